// OpenCV's triangles, which the quick fill is compared with.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

#include <functional>
#include <vector>

namespace rasterlab::bench {

/// Fills the triangles with cv::fillConvexPoly, corners at 1/256 pixel, one after the other, on one
/// thread, straight into the image, which must outlive what is returned.
std::function<void()> opencv_triangles(Image<Rgb8>& image, const std::vector<Corners>& triangles,
                                       const Rgb8& color);

}  // namespace rasterlab::bench

// OpenCV's lines, which the quick lines are compared with.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_faults.h"

#include <functional>
#include <vector>

namespace rasterlab::bench {

/// Draws the segments with cv::line, 8-connected, one after the other, on one thread, straight into
/// the image, which must outlive what is returned.
std::function<void()> opencv_lines(Image<Rgb8>& image, const std::vector<Segment>& segments,
                                   const Rgb8& color);

}  // namespace rasterlab::bench

// Exercise 03.2: a point that other things may hide.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"
#include "common/zbuffer/depth_buffer.h"

namespace rasterlab {

/// Colours pixel `point` and stores its depth z (NDC), if the depth buffer says that it is seen
/// there. Not drawn: what is outside the image; what has z outside [−1, 1], before the near or
/// behind the far plane; a z that is not a number.
///
/// `depth` is as large as `image`. Free: nothing. Cost: one comparison.
///
/// Source: A.Q27.
void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color);

}  // namespace rasterlab

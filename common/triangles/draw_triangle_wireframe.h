// Exercise 02.1: three lines.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"

#include <array>

namespace rasterlab {

/// Draws the three sides of a triangle with draw_line(), corners included. Corners are pixels, in
/// any order, inside the image or not; repeated or collinear corners give a line or one pixel.
/// Coordinates to ±2^30; throws CheckError beyond.
///
/// Free: which of two equally near pixels a side has, as in draw_line(). Cost: the sides' pixels
/// inside the image.
///
/// Source: A.Q19, B.triangle.
void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color);

}  // namespace rasterlab

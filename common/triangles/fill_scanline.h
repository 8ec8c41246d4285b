// Exercise 02.3, first part: a triangle of one colour, filled from side to side.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"
#include "common/triangles/fixed_point.h"

#include <array>

namespace rasterlab {

/// Draws all pixels of a triangle whose corners are pixels, sides included: in every row those from
/// the leftmost to the rightmost pixel of make_triangle_scanline(), as far as they are inside the
/// image. Repeated or collinear corners fill a line or one pixel. Coordinates to ±2^30; throws
/// CheckError beyond. Cost: rows and pixels inside the image.
///
/// Free: what the sides leave free, as in make_triangle_scanline().
///
/// Source: A.Q24.
void fill_triangle(Image<Rgb8>& image, const std::array<Point, 3>& corners, const Rgb8& color);

/// The same as a rung of exercise 02.4: every corner is the pixel it falls into.
///
/// Known faults: sides are drawn by both of two triangles that share them, and the triangle is up
/// to a pixel too large.
void fill_scanline(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab

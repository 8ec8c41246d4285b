// Exercise 01.7: a line of one colour.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"

namespace rasterlab {

/// Draws the segment from p0 to p1, both ends included, in one colour: the pixels of
/// line_all_octants() that are inside the image, exactly those, wherever the ends are. All other
/// pixels stay as they are.
///
/// p0 = p1 is one pixel. Coordinates to ±2^30; throws CheckError beyond. Cost: one step per pixel
/// drawn, none for what is outside the image.
///
/// Source: A.Q12.
void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color);

}  // namespace rasterlab

// Exercise 01.10: a line from one colour to another.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"

namespace rasterlab {

/// Draws the pixels that draw_line() draws, each in the colour (1 − α) c0 + α c1, α being its
/// weight in LineInterpolation; so p0 gets c0 and p1 gets c1, also where they are outside the image
/// and only a part is seen. A right answer is within 1 of 255 in every channel.
///
/// p0 = p1 is one pixel of colour c0. Coordinates to ±2^30; throws CheckError beyond. Cost: one
/// step per pixel drawn.
///
/// Source: A.Q18, C.2.1.
void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1);

}  // namespace rasterlab

// Exercise 02.3, second part: a triangle whose corners have colours.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"

#include <array>

namespace rasterlab {

/// Draws the pixels that fill_triangle() draws. In every row the colour goes linearly from that of
/// the leftmost pixel to that of the rightmost, the values of make_triangle_scanline(); a row of
/// one pixel has either. Corners outside the image count with their colours all the same. Repeated
/// or collinear corners fill a line or one pixel. Coordinates to ±2^30; throws CheckError beyond.
/// Cost: rows and pixels inside the image.
///
/// Free: what the scanline leaves free. A corner's own pixel has the corner's colour, within 1 of
/// 255, where no other corner is in the same pixel.
///
/// Source: A.Q25.
void fill_triangle_gradient(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                            const std::array<Color, 3>& colors);

}  // namespace rasterlab

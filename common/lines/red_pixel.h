// Exercise 01.2: one pixel, counted from the corner that a mathematician starts from.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

namespace rasterlab {

/// A black image with one red pixel, (255, 0, 0), in column x from the left and row `y_up` from the
/// *bottom*, both counted from 0. The image itself has row 0 at the top, as all of ours
/// (docs/conventions.md).
///
/// Throws CheckError when the image has no such pixel.
///
/// Source: B.format, whose picture is 100 × 100 with the pixel at (52, 41), saved as TGA.
Image<Rgb8> red_pixel(int width, int height, int x, int y_up);

}  // namespace rasterlab

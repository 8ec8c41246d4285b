// Exercise 01.3: a first picture, set pixel by pixel.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

namespace rasterlab {

/// Draws column x of the image as a vertical line that fades from black in the top row to white in
/// the bottom row: in row y each of red, green and blue is 255 · y / (height − 1) to the nearest
/// integer, where either neighbour will do in the middle between two. All other pixels stay as they
/// are. In an image of one row the line is black.
///
/// Throws CheckError when the image has no column x. Cost: one write per row.
///
/// Source: A.Q4.
void draw_fading_column(Image<Rgb8>& image, int x);

}  // namespace rasterlab

// Exercise 02.4, last rung: exact.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// Draws exactly the pixels inside the image that the triangle covers. Corners are snapped to 1/256
/// pixel, to nearest, ties to even; a pixel is covered when its centre is inside, or on a top edge
/// (horizontal, the inside below it) or on a left edge (the inside to its right). With integer edge
/// functions nothing is rounded after that, so triangles that share an edge leave no gap and cover
/// no pixel twice, the order of the corners does not matter, and moving a triangle by whole pixels
/// moves its pixels.
///
/// Free: nothing. Zero area covers nothing: flat, collinear or repeated corners. Corners to ±32768
/// pixels; throws CheckError beyond, or for a coordinate that is not a number. Cost: the box around
/// the triangle.
///
/// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988.
void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab

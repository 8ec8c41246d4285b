// Exercise 01.11: the edges of a mesh.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

namespace rasterlab {

/// Draws the three edges of every triangle with draw_line(), hidden ones too, seen along z: a
/// vertex is at seen_along_z(), and its pixel is the one it falls into. The right and the bottom
/// edge of the window, x = width and y = height exactly, belong to the last pixel, so that a mesh
/// that fills [−1, 1]² is seen whole. Vertices outside [−1, 1] are outside the image, and their
/// edges are cut off at it.
///
/// Vertices beyond ±2^30 pixels are taken there; edges of a vertex that is not a number are left
/// out. Cost: the pixels drawn.
///
/// Source: B.wireframe.
void draw_wireframe(Image<Rgb8>& image, const Mesh& mesh, const Rgb8& color);

}  // namespace rasterlab

// 03_zbuffer --triangles FILE: anyone's triangles, with depth.
#pragma once

#include "common/stage/stage.h"

namespace rasterlab {

/// Draws the triangles of a file with the exercises' depth buffer, one a line:
/// "x0 y0 z0 x1 y1 z1 x2 y2 z2 [r g b | r g b r g b r g b]", x and y in pixels, z NDC depth,
/// colours 0…255, white when there is none, interpolated where each corner has its own.
OwnInput own_triangles();

}  // namespace rasterlab

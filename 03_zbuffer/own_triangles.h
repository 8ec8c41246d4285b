// 03_zbuffer --triangles FILE: anyone's triangles, with depth.
#pragma once

#include "common/stage/stage.h"

namespace rasterlab {

/// Draws the triangles of a file with the exercises' depth buffer, one a line:
/// "x0 y0 z0 x1 y1 z1 x2 y2 z2 [r g b | r g b r g b r g b]", x and y in pixels, z NDC depth,
/// colours 0…255, white when there is none, interpolated where each corner has its own. With
/// --algorithm by that rung of exercise 03.5, z being taken as a perspective camera's with planes
/// at 0.1 and 1000; z is then from −1 to 1, and x and y within ±32768.
OwnInput own_triangles();

}  // namespace rasterlab

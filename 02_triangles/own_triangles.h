// 02_triangles --triangles FILE [--coverage FILE.pgm]: anyone's triangles.
#pragma once

#include "common/stage/stage.h"

namespace rasterlab {

/// Fills the triangles of a file, one a line: "x0 y0 x1 y1 x2 y2 [r g b | r g b r g b r g b]", in
/// pixels, colours 0…255, white when there is none, interpolated where each corner has its own.
/// --coverage also writes how many triangles covered each pixel.
OwnInput own_triangles();

}  // namespace rasterlab

// 01_lines --lines FILE: anyone's lines.
#pragma once

#include "common/stage/stage.h"

namespace rasterlab {

/// Draws the lines of a file, one a line: "x0 y0 x1 y1 [r g b [r g b]]", in pixels, colours 0…255,
/// white when there is none, from the first to the second where there are two.
OwnInput own_lines();

}  // namespace rasterlab

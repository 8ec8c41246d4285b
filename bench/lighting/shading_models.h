// Exercise 05.5's ladder, measured.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// A lit sphere of `rings` rings, shaded flat, by Gouraud and by Phong.
TimedLadder shading_ladder_of(int rings);

}  // namespace rasterlab::bench

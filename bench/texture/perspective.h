// Exercise 06.3's ladder, measured.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Triangles whose corners' w are up to 1 : w_ratio, their texture coordinates by each rung.
TimedLadder perspective_ladder_of(double w_ratio);

}  // namespace rasterlab::bench

// What number the matrices are multiplied in, and where the origin is.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Vertices some units before a camera that is `distance` from the world's origin, to the window.
TimedLadder matrix_chain_ladder(double distance);

}  // namespace rasterlab::bench

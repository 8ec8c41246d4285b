// How a vector can be brought to unit length.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Normals as they come out of interpolation across a triangle, each way to normalize them.
TimedLadder normalisation_ladder();

}  // namespace rasterlab::bench

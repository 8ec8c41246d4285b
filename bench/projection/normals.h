// Ways to move a normal with its surface.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Normals under matrices whose uneven scales are up to `unevenness` times each other.
TimedLadder normal_ladder(double unevenness);

}  // namespace rasterlab::bench

// How the highlight's power can be computed.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// x^exponent for x in [0, 1], every way.
TimedLadder power_ladder(int exponent);

}  // namespace rasterlab::bench

// Ways to call a fragment shader, measured.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// A shader of a dozen operations, where the call counts, and Phong's, where it hardly does.
TimedLadder flat_call_ladder();
TimedLadder phong_call_ladder();

}  // namespace rasterlab::bench

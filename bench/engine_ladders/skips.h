// What the engine spares itself, measured switch by switch.
#pragma once

#include "bench/support/ladder.h"

#include <string>

namespace rasterlab::bench {

/// A scene of bench/engine/scenes.h, with each of the engine's Skips off in turn.
TimedLadder skip_ladder(const std::string& scene);

}  // namespace rasterlab::bench

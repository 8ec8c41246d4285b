// What the engine spares itself, measured switch by switch.
#pragma once

#include "bench/engine/scenes.h"
#include "bench/support/ladder.h"

#include <vector>

namespace rasterlab::bench {

/// A scene for each kind of skipping.
std::vector<SceneEntry> skip_scenes();

/// The scene, with each of the engine's Skips off in turn.
TimedLadder skip_ladder(const SceneEntry& entry);

}  // namespace rasterlab::bench

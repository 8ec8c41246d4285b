// How the engine works, none of which changes a pixel.
#pragma once

#include "common/engine/simd_target.h"

namespace rasterlab {

/// What the engine spares itself. Each can be switched off, to see what it is worth.
struct Skips {
  bool outside = true;        ///< clusters outside the view
  bool facing_away = true;    ///< clusters all of whose triangles are culled by the side they show
  bool hidden = true;         ///< clusters, triangles and blocks behind what is already drawn
  bool missed = true;         ///< triangles that miss every sample
  bool front_to_back = true;  ///< not a skip itself: draws near clusters first, so more is hidden
};

struct EngineOptions {
  int threads = 0;  ///< 0: as many as there are cores
  SimdTarget simd = best_simd_target();
  bool pin_threads = false;  ///< each thread stays on one core, for measuring
  Skips skip = {};
};

}  // namespace rasterlab

// How the engine works, none of which changes a pixel.
#pragma once

#include "common/engine/simd_target.h"

namespace rasterlab {

/// What the engine spares itself that can be switched off, to see what it is worth.
struct Skips {
  bool outside = true;            ///< clusters outside the view
  bool facing_away = true;        ///< clusters of which culling leaves nothing
  bool hidden_clusters = true;    ///< clusters behind what is already drawn
  bool hidden_triangles = true;   ///< triangles, or what of them is in a block of 8×8 pixels
  bool front_to_back = true;      ///< draws near clusters first, so that more is hidden
  bool unwanted_depth = true;     ///< depth and triangle numbers that a draw call need not keep
  bool undisputed_blocks = true;  ///< of those, the ones of 8×8 pixels no two triangles compete for
};

struct EngineOptions {
  int threads = 0;  ///< 0: as many as there are cores
  SimdTarget simd = best_simd_target();
  bool pin_threads = false;  ///< each thread stays on one core, for measuring
  Skips skip = {};
};

}  // namespace rasterlab

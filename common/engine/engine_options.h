// How the engine works, none of which changes a pixel.
#pragma once

#include "common/engine/simd_target.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace rasterlab {

/// What the engine spares itself that can be switched off, to see what it is worth.
struct Skips {
  bool outside = true;            ///< clusters outside the view
  bool facing_away = true;        ///< clusters of which culling leaves nothing
  bool hidden_clusters = true;    ///< clusters behind what is already drawn
  bool hidden_triangles = true;   ///< triangles, or what of them is in a block of 8×8 pixels
  bool front_to_back = true;      ///< draws near clusters first, so that more is hidden
  bool skipped_vertices = true;   ///< of clusters that are left out for one of these three reasons
  bool back_faces = true;         ///< triangles that culling leaves out
  bool zero_area = true;          ///< triangles that snapping left no area
  bool missed_samples = true;     ///< triangles in the picture that have no sample in their box
  bool hidden_fragments = true;   ///< shades when all is drawn, each visible pixel once
  bool unread_attributes = true;  ///< derivatives of varyings that a shader doesn't read
  bool untouched_tiles = true;    ///< tiles nothing is drawn into
  bool unwanted_depth = true;     ///< depth and triangle numbers that a draw call need not keep
  bool undisputed_blocks = true;  ///< of those, the ones of 8×8 pixels no two triangles compete for
};

struct NamedSkip {
  const char* name;
  bool Skips::*skip;
};

/// All of them, for those who switch one off after the other.
inline constexpr std::array<NamedSkip, 14> named_skips = {
    {{"outside", &Skips::outside},
     {"facing away", &Skips::facing_away},
     {"hidden clusters", &Skips::hidden_clusters},
     {"hidden triangles", &Skips::hidden_triangles},
     {"front to back", &Skips::front_to_back},
     {"skipped vertices", &Skips::skipped_vertices},
     {"back faces", &Skips::back_faces},
     {"zero area", &Skips::zero_area},
     {"missed samples", &Skips::missed_samples},
     {"hidden fragments", &Skips::hidden_fragments},
     {"unread attributes", &Skips::unread_attributes},
     {"untouched tiles", &Skips::untouched_tiles},
     {"unwanted depth", &Skips::unwanted_depth},
     {"undisputed blocks", &Skips::undisputed_blocks}}};

/// Nothing is skipped.
constexpr Skips no_skips() {
  Skips skips;
  for (const NamedSkip& one : named_skips) skips.*one.skip = false;
  return skips;
}

/// All but those of these names. Names of none of them don't matter.
inline Skips skips_without(const std::vector<std::string>& names) {
  Skips skips;
  for (const NamedSkip& one : named_skips) {
    skips.*one.skip = std::find(names.begin(), names.end(), one.name) == names.end();
  }
  return skips;
}

struct EngineOptions {
  int threads = 0;  ///< 0: as many as there are cores
  SimdTarget simd = best_simd_target();
  bool pin_threads = false;  ///< each thread stays on one core, for measuring
  Skips skip = {};
};

}  // namespace rasterlab

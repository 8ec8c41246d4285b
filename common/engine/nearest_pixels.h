// Vectors of a tile's pixels, each of which keeps what is nearest.
#pragma once

#include "common/engine/frame_access.h"
#include "common/engine/simd.h"

namespace rasterlab::RASTERLAB_SIMD {

/// Depths and keys of a tile. Covered pixels of a vector get new ones where the depth is nearer.
class NearestPixels {
 public:
  NearestPixels(const Tile& tile, std::uint32_t key)
      : depth_(tile.depth), key_(tile.key), own_key_(static_cast<std::int32_t>(key)) {}

  /// `place`: of the vector in the tile's arrays.
  void write(int place, Truth covered, Number depth) const {
    float* there = depth_ + place;
    const Number old_depth = load(there);
    if (key_ == nullptr) {
      store(select(covered, maximum(depth, old_depth), old_depth), there);
      return;
    }
    std::uint32_t* key_there = key_ + place;
    const Ints old_key = load(key_there);
    const Truth nearer =
        covered && (depth > old_depth || (depth == old_depth && own_key_ < old_key));
    store(select(nearer, depth, old_depth), there);
    store(select(nearer, own_key_, old_key), key_there);
  }

 private:
  float* depth_;
  std::uint32_t* key_;  ///< nullptr: nobody asks for them
  Ints own_key_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

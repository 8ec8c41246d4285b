// What triangles drawn one per lane hit: gathered first, then written to the depth buffer in one
// go.
//
// Lanes hit pixels anywhere in the tile, two of them perhaps the same one, so hits are written one
// by one. Which lanes hit, step after step, no processor can guess; so no branch depends on it: the
// hits are pushed together into a list, and one loop writes them all.
#pragma once

#include "common/engine/frame_access.h"
#include "common/engine/kernels.h"
#include "common/engine/simd.h"

#include <bit>
#include <utility>

namespace rasterlab::RASTERLAB_SIMD {

/// Where in a tile's arrays pixels are.
inline Ints place_in_tile(const Tile& tile, Ints x, Ints y) {
  const Ints block_row(64 * tile.blocks_per_row() - 64);
  return (x + shift_right<3>(x) * Ints(56)) + (shift_left<3>(y) + shift_right<3>(y) * block_row);
}

class HitList {
 public:
  explicit HitList(const Tile& tile) : tile_(tile) {}

  /// Lanes of `hit`, at places in the tile. Writes what there is when the list is full.
  void add(Truth hit, Ints place, Number depth, Ints key) {
    if (count_ > capacity) write();
    store_packed(hit, place, place_.data() + count_);
    store_packed(hit, bit_pattern(depth), depth_.data() + count_);
    if (tile_.has_keys()) store_packed(hit, key, key_.data() + count_);
    count_ += std::popcount(bits(hit));
  }

  void write() {
    for (int i = 0; i < count_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      write_one(place_[at], std::bit_cast<float>(depth_[at]), static_cast<std::uint32_t>(key_[at]));
    }
    count_ = 0;
  }

  /// Without a branch on which of two is nearer; equal depths are rare.
  void write_one(std::int32_t place, float depth, std::uint32_t key) {
    float& depth_there = tile_.depth[place];
    written_ |= BlockMask{1} << (place >> 6);
    if (!tile_.has_keys()) {
      depth_there = std::max(depth, depth_there);
      return;
    }
    std::uint32_t& key_there = tile_.key[place];
    const std::uint32_t nearer = 0U - static_cast<std::uint32_t>(depth > depth_there);
    if (depth == depth_there) {
      key_there = std::min(key_there, key);
      return;
    }
    key_there ^= (key ^ key_there) & nearer;
    depth_there = depth > depth_there ? depth : depth_there;
  }

  /// Blocks written to since the last call.
  BlockMask take_written_blocks() { return std::exchange(written_, 0); }

 private:
  static constexpr int capacity = 512;
  using Values = std::array<std::int32_t, capacity + 2 * lanes>;

  const Tile& tile_;
  BlockMask written_ = 0;
  int count_ = 0;
  alignas(64) Values place_;
  alignas(64) Values depth_;
  alignas(64) Values key_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

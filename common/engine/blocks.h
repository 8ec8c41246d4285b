// A tile's blocks of 8×8 pixels, and what is known of each: how far away its farthest pixel is.
#pragma once

#include "common/engine/kernels.h"
#include "common/engine/simd.h"

#include <algorithm>
#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

inline constexpr int groups = 64 / lanes;  // vectors in a block
inline constexpr std::uint32_t all_lanes = 0xFFFFFFFFU >> (32 - lanes);

/// Those of a vector that begins with bit `first` of the mask.
inline std::uint32_t lanes_at(BlockMask mask, int first) {
  return static_cast<std::uint32_t>(mask >> first) & all_lanes;
}

/// Per pixel of a block, its place.
struct BlockPlaces {
  alignas(64) std::array<std::int32_t, 64> x;
  alignas(64) std::array<std::int32_t, 64> y;

  constexpr BlockPlaces() : x(), y() {
    for (std::size_t i = 0; i < 64; ++i) {
      x[i] = static_cast<std::int32_t>(i % 8);
      y[i] = static_cast<std::int32_t>(i / 8);
    }
  }
};
inline constexpr BlockPlaces places;

/// A way in a tile.
struct PixelOffset {
  int x, y;
};

/// A block's first pixel.
inline PixelOffset place_of_block(const Tile& tile, int block) {
  const auto per_row = static_cast<unsigned>(tile.blocks_per_row());  // a power of two
  return {(block & (tile.blocks_per_row() - 1)) * 8, (block >> std::countr_zero(per_row)) * 8};
}

/// How something linear changes over a block, from vector to vector.
template <class Values>
struct BlockSteps {
  Values first;        ///< over the lanes of a block's first vector
  Values along;        ///< to the next one in the same row
  Values to_next_row;  ///< to the next one when that begins a row

  BlockSteps() = default;
  /// `change(way)` is how much it changes along a PixelOffset.
  template <class Change>
  BlockSteps(const Change& change, Values over_lanes)
      : first(over_lanes),
        along(change(PixelOffset{lanes, 0})),
        to_next_row(change(PixelOffset{lanes < 8 ? lanes - 8 : 0, lanes < 8 ? 1 : lanes / 8})) {}

  /// In the vector after vector `g`, which has `values`.
  Values after(int g, Values values) const {
    return values + ((g + 1) * lanes % 8 == 0 ? to_next_row : along);
  }
};

/// Blocks that a box of pixels reaches into; left ≤ right and top ≤ bottom, all in the tile.
inline BlockMask blocks_in_bounds(const Tile& tile, int left, int right, int top, int bottom) {
  const auto ones = [](int count) { return all_64 >> (64 - count); };
  const int per_row = tile.blocks_per_row();
  const BlockMask first_of_rows = ones(tile.block_count()) / ones(per_row);
  const BlockMask columns = (ones(right / 8 - left / 8 + 1) << (left / 8)) * first_of_rows;
  return columns & ones((bottom / 8 - top / 8 + 1) * per_row) << (top / 8 * per_row);
}

/// Those of `blocks` of which not every pixel is nearer than `nearest`.
inline BlockMask without_hidden(const Tile& tile, BlockMask blocks, float nearest,
                                Statistics& statistics) {
  BlockMask before = 0;
  for (int first = 0; first < tile.block_count(); first += lanes) {
    const Truth far = load(tile.block_far + first) > Number(nearest);
    before |= static_cast<BlockMask>(bits(far)) << first;
  }
  statistics.blocks_hidden += static_cast<unsigned>(std::popcount(blocks & before));
  return blocks & ~before;
}

/// After pixels of these blocks were drawn.
inline void update_far(const Tile& tile, BlockMask blocks) {
  for (; blocks != 0; blocks &= blocks - 1) {
    const int block = std::countr_zero(blocks);
    Number far = load(tile.depth + block * 64);
    for (int g = 1; g < groups; ++g) {
      far = minimum(far, load(tile.depth + block * 64 + g * lanes));
    }
    tile.block_far[block] = smallest(far);
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD

// Pixels of a tile that hardly share their triangles with their neighbours.
//
// Where a block of 8×8 pixels sees about as many triangles as pixels, what a vector of them needs
// to know lies in as many records as it has lanes: nothing is won by keeping neighbours together.
// Such pixels are put on a list, one by one, from all of a tile's blocks, so that vectors are full
// although the blocks are not.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rasterlab {

struct ScatteredPixels {
  static constexpr std::size_t most = std::size_t{64} * 64;
  /// Behind the last pixel there is room for so many more, which repeat it.
  static constexpr std::size_t room = 64;
  using Values = std::array<std::int32_t, most + room>;

  std::size_t count = 0;
  alignas(64) Values place;   ///< in the tile's arrays
  alignas(64) Values column;  ///< of the picture
  alignas(64) Values row;
  alignas(64) Values slot;  ///< the triangle's; its key until all have slots
  /// Per place in the tile's arrays, packed.
  alignas(64) std::array<std::uint32_t, most> color;
  /// Which of a block's pixels they are.
  std::array<std::uint64_t, most / 64> in_block;

  void clear() {
    count = 0;
    in_block.fill(0);
  }

  /// So that whole vectors may be read.
  void repeat_last() {
    if (count == 0) return;
    for (Values* values : {&place, &column, &row, &slot}) {
      std::fill_n(values->data() + count, room, (*values)[count - 1]);
    }
  }
};

}  // namespace rasterlab

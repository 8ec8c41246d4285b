// Depth and triangle number of each of a tile's pixels in one word: for triangles whose samples lie
// anywhere, one by one. Which of two is seen is one comparison, and a sample one cache line.
#pragma once

#include "common/engine/frame_access.h"
#include "common/engine/kernels.h"
#include "common/engine/simd.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

/// Of positive floats the bits are in the order of the numbers; a negative depth, which isn't seen,
/// makes the word negative. Equal depths: the earlier triangle, of the lower number, has the larger
/// word.
inline void store_pixel_words(Number depth, Ints key, std::int64_t* to) {
  store_words(Ints(-1) - key, bit_pattern(depth), to);
}

inline void load_pixel_words(const std::int64_t* from, Number& depth, Ints& key) {
  Ints complement;
  Ints depth_bits;
  load_words(from, complement, depth_bits);
  depth = from_bit_pattern(depth_bits);
  key = Ints(-1) - complement;
}

inline float depth_of_word(std::int64_t word) {
  return std::bit_cast<float>(static_cast<std::int32_t>(word >> 32));
}
inline std::uint32_t key_of_word(std::int64_t word) {
  return ~static_cast<std::uint32_t>(word);
}

inline void read_pixels(const Tile& tile, PixelWords& words) {
  for (int i = 0; i < tile.pixel_count(); i += lanes) {
    store_pixel_words(load(tile.depth + i), load(tile.key + i), words.data() + i);
  }
}

/// Back into the tile, and the farthest depth of each of its blocks.
inline void write_pixels(const PixelWords& words, const Tile& tile) {
  for (int block = 0; block < tile.block_count(); ++block) {
    Number far(1);
    for (int i = 64 * block; i < 64 * (block + 1); i += lanes) {
      Number depth;
      Ints key;
      load_pixel_words(words.data() + i, depth, key);
      store(depth, tile.depth + i);
      store(key, tile.key + i);
      far = minimum(far, depth);
    }
    tile.block_far[block] = smallest(far);
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD

// A framebuffer as the engine's inside sees it.
#pragma once

#include "common/engine/framebuffer.h"
#include "common/engine/undisputed_blocks.h"

#include <array>

namespace rasterlab {

/// One tile's share of a framebuffer.
struct Tile {
  int index = 0;
  int left = 0;  ///< of the picture's pixels
  int top = 0;
  int size = 0;   ///< a side, in pixels
  int width = 0;  ///< what of it lies in the picture
  int height = 0;
  float* depth = nullptr;
  std::uint32_t* key = nullptr;  ///< nullptr: nobody asks which triangle is seen, only how far away
  float* block_far = nullptr;    ///< per block: no pixel's depth is less
  UndisputedBlocks* undisputed = nullptr;  ///< nullptr: each block has depths and keys
  Rgb8* color = nullptr;                   ///< the tile's first pixel in the picture …
  std::ptrdiff_t stride = 0;               ///< … and how far it is to the next row

  bool has_keys() const { return key != nullptr; }
  int blocks_per_row() const { return size / 8; }
  /// Which block the pixel (x, y) of the tile is in.
  int block_at(int x, int y) const { return y / 8 * blocks_per_row() + x / 8; }
  int block_count() const { return size * size / 64; }
  int pixel_count() const { return size * size; }
};

/// Room for the depth and keys of a tile that a framebuffer needn't keep.
struct TileMemory {
  static constexpr std::size_t most_pixels = std::size_t{64} * 64;

  UndisputedBlocks undisputed;
  alignas(64) std::array<float, 64> block_far;
  alignas(64) std::array<float, most_pixels> depth;
  alignas(64) std::array<std::uint32_t, most_pixels> key;
};

class FrameAccess {
 public:
  enum ColorState : std::uint8_t { stale, background, picture };
  /// Nothing; with depth and keys in the framebuffer; with them elsewhere for a while.
  enum DrawnState : std::uint8_t { not_drawn, drawn_here, drawn_in_passing };

  explicit FrameAccess(Framebuffer& frame) : frame_(frame) {}

  int width() const { return frame_.width_; }
  int height() const { return frame_.height_; }
  int tile_size() const { return frame_.tile_size_; }
  int tiles_x() const { return frame_.tiles_x_; }
  int tiles_y() const { return frame_.tiles_y_; }
  int tile_count() const { return frame_.tile_count(); }
  std::uint32_t& keys_used() const { return frame_.keys_used_; }
  Keep& kept() const { return frame_.kept_; }
  float& tile_far(int tile) const { return frame_.tile_far_[static_cast<std::size_t>(tile)]; }
  float* block_far(int tile) const {
    return frame_.block_far_.get() + static_cast<std::ptrdiff_t>(tile) * frame_.tile_pixels() / 64;
  }
  const float* tile_fars() const { return frame_.tile_far_.get(); }
  const float* block_fars() const { return frame_.block_far_.get(); }
  const std::uint8_t* drawn() const { return frame_.drawn_.data(); }

  Tile tile(int index) const {
    Tile tile;
    tile.index = index;
    tile.size = frame_.tile_size_;
    tile.left = index % frame_.tiles_x_ * tile.size;
    tile.top = index / frame_.tiles_x_ * tile.size;
    tile.width = std::min(tile.size, frame_.width_ - tile.left);
    tile.height = std::min(tile.size, frame_.height_ - tile.top);
    const auto first = static_cast<std::ptrdiff_t>(index) * frame_.tile_pixels();
    tile.depth = frame_.depth_.get() + first;
    tile.key = frame_.key_.get() + first;
    tile.block_far = block_far(index);
    tile.color = frame_.color_.row(tile.top) + tile.left;
    tile.stride = frame_.width_;
    return tile;
  }

  /// A tile with its depth and keys elsewhere.
  Tile tile_in(TileMemory& memory, int index) const {
    Tile there = tile(index);
    there.depth = memory.depth.data();
    there.key = memory.key.data();
    there.block_far = memory.block_far.data();
    return there;
  }

  /// Wipes a tile that nothing was drawn into since clear().
  void prepare(const Tile& tile) const {
    std::uint8_t& drawn = frame_.drawn_[static_cast<std::size_t>(tile.index)];
    if (drawn != not_drawn) return;
    drawn = tile.block_far == block_far(tile.index) ? drawn_here : drawn_in_passing;
    std::fill_n(tile.block_far, tile.block_count(), 0.0F);
    if (tile.undisputed != nullptr) {
      tile.undisputed->begin(tile.block_count());
      return;
    }
    std::fill_n(tile.depth, tile.pixel_count(), 0.0F);
    if (tile.has_keys()) std::fill_n(tile.key, tile.pixel_count(), 0U);
  }

  std::uint8_t& color_state(int index) const {
    return frame_.has_color_[static_cast<std::size_t>(index)];
  }
  void fill_background(int index) const { frame_.fill_background(index); }

 private:
  Framebuffer& frame_;
};

}  // namespace rasterlab

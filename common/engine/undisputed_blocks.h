// Blocks of 8×8 pixels in which no two triangles compete for a pixel: they need neither a depth nor
// a triangle number for each pixel, only which pixels each triangle has.
#pragma once

#include "common/engine/depth_bounds.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterlab {

/// Which pixels of 64 (a block of 8×8, row by row, the first in the lowest bit), or which blocks of
/// a tile.
using BlockMask = std::uint64_t;

/// Every pixel of a block, or every block of the largest tile.
inline constexpr BlockMask all_64 = ~BlockMask{0};

/// A triangle's depth all over a tile: d0 + (E1·k1 + E2·k2), with its edge functions 1 and 2.
struct DepthPlane {
  struct Edge {
    std::int64_t exact;   ///< at the tile's first pixel
    std::int32_t step_x;  ///< for 1/256 pixel: of 256 units, the 256th part
    std::int32_t step_y;
  };

  std::uint32_t key;  ///< the triangle's number
  bool is_short;      ///< 32 bits hold the edge functions where the triangle is
  float d0, k1, k2;
  std::array<Edge, 2> edge;
};

/// A tile's.
class UndisputedBlocks {
 public:
  /// Pixels of a block, and whose they are.
  struct Part {
    BlockMask pixels;
    std::int32_t plane;
  };

  /// No triangle is drawn in any of the tile's blocks.
  void begin(int blocks) {
    mask_ = all_64 >> (64 - blocks);
    for (int block = 0; block < blocks; ++block) at(block).clear();
    planes_.clear();
  }

  BlockMask mask() const { return mask_; }
  bool has(int block) const { return (mask_ >> block & 1U) != 0; }
  /// These have a depth and a number for each pixel from now on.
  void remove(BlockMask blocks) { mask_ &= ~blocks; }

  std::span<const Part> parts(int block) const {
    const Block& b = at(block);
    return std::span(b.part).first(b.count);
  }
  const std::vector<DepthPlane>& planes() const { return planes_; }
  const DepthPlane& plane_of(const Part& part) const {
    return planes_[static_cast<std::size_t>(part.plane)];
  }

  /// For add().
  std::int32_t add_plane(const DepthPlane& plane) {
    planes_.push_back(plane);
    return static_cast<std::int32_t>(planes_.size()) - 1;
  }

  /// Draws pixels of one triangle, whose depths are above 0 and within the bounds. False, and
  /// nothing is drawn, when some of them are another's and which is nearer must be asked pixel by
  /// pixel, or when there is no room. `block_far` stays what no depth in the block is less than.
  bool add(int block, BlockMask pixels, DepthBounds<float> depths, std::int32_t plane,
           float& block_far) {
    Block& b = at(block);
    bool in_front = false;
    if ((pixels & b.covered) != 0) {
      const bool behind = depths.near < b.depths.far;
      in_front = depths.far > b.depths.near;
      if (!behind && !in_front) return false;
      if (behind) pixels &= ~b.covered;
      if (pixels == 0) return true;
    }
    if (b.count == most_parts) return false;
    if (in_front) b.uncover(pixels);
    b.part[b.count++] = {pixels, plane};
    b.covered |= pixels;
    b.depths = {std::min(b.depths.far, depths.far), std::max(b.depths.near, depths.near)};
    if (b.covered == all_64) block_far = b.depths.far;
    return true;
  }

  /// Blocks that show a triangle.
  int count() const {
    int found = 0;
    for (int block = 0; block < 64; ++block) found += has(block) && at(block).count > 0 ? 1 : 0;
    return found;
  }

 private:
  static constexpr std::size_t most_parts = 8;
  /// Of a block without parts: joined with a part's, they are just those.
  static constexpr DepthBounds<float> no_depths = {2, 0};

  struct Block {
    std::size_t count = 0;
    BlockMask covered = 0;
    DepthBounds<float> depths = no_depths;  ///< of all parts
    std::array<Part, most_parts> part;

    void clear() {
      count = 0;
      covered = 0;
      depths = no_depths;
    }
    void uncover(BlockMask pixels) {
      for (Part& one : std::span(part).first(count)) one.pixels &= ~pixels;
      const auto end =
          std::remove_if(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count),
                         [](const Part& one) { return one.pixels == 0; });
      count = static_cast<std::size_t>(end - part.begin());
      if (count == 0) clear();
    }
  };

  Block& at(int block) { return block_[static_cast<std::size_t>(block)]; }
  const Block& at(int block) const { return block_[static_cast<std::size_t>(block)]; }

  BlockMask mask_ = 0;
  std::array<Block, 64> block_;
  std::vector<DepthPlane> planes_;
};

}  // namespace rasterlab

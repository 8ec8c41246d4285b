// The depths of a triangle in blocks of pixels.
#pragma once

#include "common/engine/blocks.h"
#include "common/engine/undisputed_blocks.h"

namespace rasterlab::RASTERLAB_SIMD {

inline std::int64_t change(const DepthPlane::Edge& edge, PixelOffset way) {
  return 256 * (static_cast<std::int64_t>(edge.step_x) * way.x +
                static_cast<std::int64_t>(edge.step_y) * way.y);
}

/// Depths in a plane, which must outlive it, a vector of them at a time.
class PlaneDepths {
 public:
  explicit PlaneDepths(const DepthPlane& plane)
      : plane_(&plane), d0_(plane.d0), k1_(plane.k1), k2_(plane.k2) {
    const Ints x = load(places.x.data());
    const Ints y = load(places.y.data());
    for (std::size_t i = 0; i < 2; ++i) {
      const DepthPlane::Edge& edge = plane.edge[i];
      if (plane.is_short) {
        short_[i] = BlockSteps<Ints>(
            [&](PixelOffset way) { return static_cast<std::int32_t>(change(edge, way)); },
            short_changes(edge, x, y));
      } else {
        long_[i] = BlockSteps<Doubles>(
            [&](PixelOffset way) { return static_cast<double>(change(edge, way)); },
            long_changes(edge, x, y));
      }
    }
  }

  /// Calls `visit(g, depth)` for each vector of the block whose first pixel is `corner`.
  template <class Visit>
  void for_each_vector(PixelOffset corner, const Visit& visit) const {
    if (plane_->is_short) {
      walk<Ints, std::int32_t>(
          short_, corner, [](Ints edge) { return as_numbers(edge); }, visit);
    } else {
      walk<Doubles, double>(
          long_, corner, [](Doubles edge) { return to_number(edge); }, visit);
    }
  }

  /// Of blocks that the triangle covers wholly, a vector of them, with their first pixels at
  /// (x, y). Whatever is rounded is rounded the same way for neighbouring numbers, so that depth
  /// only grows, or only falls, with either edge function: nothing in a block is farther or nearer
  /// than where each of them is least or largest.
  DepthBounds<Number> in_blocks(Ints x, Ints y) const {
    const auto edge = [&](std::size_t i, bool largest) {
      const DepthPlane::Edge& e = plane_->edge[i];
      const PixelOffset way = {(e.step_x > 0) == largest ? 7 : 0,
                               (e.step_y > 0) == largest ? 7 : 0};
      const std::int64_t first = e.exact + change(e, way);
      return plane_->is_short
                 ? as_numbers(Ints(static_cast<std::int32_t>(first)) + short_changes(e, x, y))
                 : to_number(Doubles(static_cast<double>(first)) + long_changes(e, x, y));
    };
    const bool grows1 = plane_->k1 > 0;
    const bool grows2 = plane_->k2 > 0;
    return {depth(edge(0, !grows1), edge(1, !grows2)), depth(edge(0, grows1), edge(1, grows2))};
  }

 private:
  template <class Values, class Value, class ToNumber, class Visit>
  void walk(const std::array<BlockSteps<Values>, 2>& steps, PixelOffset corner,
            const ToNumber& to_number, const Visit& visit) const {
    const auto first = [&](std::size_t i) {
      const DepthPlane::Edge& edge = plane_->edge[i];
      return Values(static_cast<Value>(edge.exact + change(edge, corner))) + steps[i].first;
    };
    Values edge1 = first(0);
    Values edge2 = first(1);
    for (int g = 0; g < groups; ++g) {
      visit(g, depth(to_number(edge1), to_number(edge2)));
      edge1 = steps[0].after(g, edge1);
      edge2 = steps[1].after(g, edge2);
    }
  }

  static Ints short_changes(const DepthPlane::Edge& edge, Ints x, Ints y) {
    return shift_left<8>(x * Ints(edge.step_x) + y * Ints(edge.step_y));
  }
  static Doubles long_changes(const DepthPlane::Edge& edge, Ints x, Ints y) {
    return to_doubles(x) * Doubles(256.0 * edge.step_x) +
           to_doubles(y) * Doubles(256.0 * edge.step_y);
  }
  Number depth(Number e1, Number e2) const { return d0_ + (e1 * k1_ + e2 * k2_); }

  const DepthPlane* plane_;
  Number d0_, k1_, k2_;
  std::array<BlockSteps<Ints>, 2> short_;
  std::array<BlockSteps<Doubles>, 2> long_;
};

/// First pixels of the blocks from `first` on, one per lane.
struct BlockCorners {
  Ints x, y;

  BlockCorners(const Tile& tile, int first) {
    const int per_row = tile.blocks_per_row();
    const Ints block = iota(first);
    const Ints row = per_row == 8   ? shift_right<3>(block)
                     : per_row == 4 ? shift_right<2>(block)
                                    : shift_right<1>(block);
    x = shift_left<3>(block & Ints(per_row - 1));
    y = shift_left<3>(row);
  }
};

/// Calls `visit(block)` for each.
template <class Visit>
void for_each_block(BlockMask blocks, const Visit& visit) {
  for (; blocks != 0; blocks &= blocks - 1) visit(std::countr_zero(blocks));
}

/// Whether each pixel of these blocks has a depth and a number.
inline bool have_pixels(const Tile& tile, BlockMask blocks) {
  return tile.undisputed == nullptr || (tile.undisputed->mask() & blocks) == 0;
}

/// Those of `blocks` that are undisputed get a depth and a number for each pixel, so that others
/// can be drawn there.
inline void give_pixels(const Tile& tile, BlockMask blocks) {
  if (tile.undisputed == nullptr) return;
  blocks &= tile.undisputed->mask();
  tile.undisputed->remove(blocks);
  for_each_block(blocks, [&](int block) {
    float* depth = tile.depth + block * 64;
    std::uint32_t* key = tile.has_keys() ? tile.key + block * 64 : nullptr;
    std::fill_n(depth, 64, 0.0F);
    if (key != nullptr) std::fill_n(key, 64, 0U);
    for (const UndisputedBlocks::Part& part : tile.undisputed->parts(block)) {
      const DepthPlane& plane = tile.undisputed->plane_of(part);
      const Ints own_key(static_cast<std::int32_t>(plane.key));
      PlaneDepths(plane).for_each_vector(place_of_block(tile, block), [&](int g, Number own) {
        const int pixel = g * lanes;
        const Truth here = truth_of(lanes_at(part.pixels, pixel));
        store(select(here, own, load(depth + pixel)), depth + pixel);
        if (key != nullptr) store(select(here, own_key, load(key + pixel)), key + pixel);
      });
    }
  });
}

}  // namespace rasterlab::RASTERLAB_SIMD

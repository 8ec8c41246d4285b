// Triangles of any size, one by one in blocks of 8×8 pixels: blocks wholly outside an edge are left
// out, blocks wholly inside ask no edge.
#pragma once

#include "common/engine/blocks.h"

namespace rasterlab::RASTERLAB_SIMD {

/// A way in a tile.
struct PixelOffset {
  int x, y;
};

/// An edge function over one tile of at most 64×64 pixels.
///
/// Pixels are 256 units apart, so whether the function is at least 0 can be asked of it divided by
/// 256 and rounded down, whose steps are coordinate differences, below 2^24 in magnitude. Over a
/// tile it changes by less than 2^31; if it has both signs there, it fits 32 bits everywhere.
struct TileEdge {
  std::int64_t exact;   ///< at the tile's first pixel
  std::int32_t step_x;  ///< of the divided function, per pixel
  std::int32_t step_y;
  std::int32_t divided;  ///< at the tile's first pixel; all three are 0 when all the tile is inside
  std::int32_t test_x;
  std::int32_t test_y;
  bool misses;  ///< all the tile is outside

  TileEdge() = default;
  TileEdge(const LargeTriangle& t, std::size_t i, const Tile& tile) {
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    step_x = t.y[a] - t.y[b];
    step_y = t.x[b] - t.x[a];
    const std::int64_t px = tile.left * 256 + 128;
    const std::int64_t py = tile.top * 256 + 128;
    exact = step_y * (py - t.y[a]) + step_x * (px - t.x[a]);
    const bool owns = step_x > 0 || (step_x == 0 && step_y > 0);
    const std::int64_t first = (exact - (owns ? 0 : 1)) >> 8;
    const std::int64_t reach = tile.size - 1;
    const std::int64_t low = first + reach * (std::min(step_x, 0) + std::min(step_y, 0));
    const std::int64_t high = first + reach * (std::max(step_x, 0) + std::max(step_y, 0));
    misses = high < 0;
    const bool asks = low < 0;
    divided = asks && !misses ? static_cast<std::int32_t>(first) : 0;
    test_x = asks ? step_x : 0;
    test_y = asks ? step_y : 0;
  }

  std::int64_t at(int x, int y) const { return exact + change({x, y}); }
  std::int64_t change(PixelOffset way) const {
    return 256 *
           (static_cast<std::int64_t>(step_x) * way.x + static_cast<std::int64_t>(step_y) * way.y);
  }
  /// Of the divided function.
  std::int32_t test_at(int x, int y) const { return divided + test_change({x, y}); }
  std::int32_t test_change(PixelOffset way) const { return test_x * way.x + test_y * way.y; }
};

/// From edge functions 1 and 2 to depth.
struct DepthSlopes {
  Number d0, k1, k2;
  /// Twice the area is below 2^31, and so are edge functions inside: 32 bits hold them there,
  /// however often they have overflown on the way.
  bool is_short;

  DepthSlopes() = default;
  DepthSlopes(const LargeTriangle& t, const TileEdge& edge0) {
    const auto area = static_cast<double>(edge0.step_y) * (t.y[0] - t.y[1]) +
                      static_cast<double>(edge0.step_x) * (t.x[0] - t.x[1]);
    const double inverse = 1.0 / area;
    const double depth0 = t.depth[0];
    d0 = Number(t.depth[0]);
    k1 = Number(static_cast<float>((t.depth[1] - depth0) * inverse));
    k2 = Number(static_cast<float>((t.depth[2] - depth0) * inverse));
    is_short = area < 2147483648.0;
  }

  Number depth(Number e1, Number e2) const { return d0 + (e1 * k1 + e2 * k2); }
};

/// Blocks in which a triangle may be seen.
inline BlockMask open_blocks(const DrawJob& job, const Tile& tile, const LargeTriangle& t,
                             float nearest, Statistics& statistics) {
  const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const auto inside = [&](int pixel) { return std::clamp(pixel, 0, tile.size - 1); };
  const BlockMask near = blocks_in_bounds(
      tile, inside(((low_x + 127) >> 8) - tile.left), inside(((high_x - 128) >> 8) - tile.left),
      inside(((low_y + 127) >> 8) - tile.top), inside(((high_y - 128) >> 8) - tile.top));
  return job.skip.hidden_triangles ? without_hidden(tile, near, nearest, statistics) : near;
}

class LargeDrawing {
 public:
  /// Draws into the blocks `open`, at least one.
  LargeDrawing(const DrawJob& job, const Tile& tile, const LargeTriangle& triangle, BlockMask open)
      : job_(job), tile_(tile), triangle_(triangle), open_(open) {
    for (std::size_t i = 0; i < 3; ++i) edge_[i] = TileEdge(triangle, i, tile);
  }

  bool misses() const { return edge_[0].misses || edge_[1].misses || edge_[2].misses; }

  void draw(Worker& worker) {
    find_blocks();
    if (touched_ == 0) return;
    prepare_depth();
    if ((touched_ & ~inside_) != 0) prepare_coverage();
    for (BlockMask rest = touched_; rest != 0; rest &= rest - 1) {
      const int block = std::countr_zero(rest);
      if ((inside_ >> block & 1U) != 0) {
        draw_block<true>(block, worker);
      } else {
        draw_block<false>(block, worker);
      }
    }
  }

 private:
  /// Which blocks may have a covered pixel, which are covered wholly.
  void find_blocks() {
    const int per_row = tile_.blocks_per_row();
    const Ints column_mask(per_row - 1);
    const int first_block = std::countr_zero(open_) / lanes * lanes;
    const int last_block = 64 - std::countl_zero(open_);
    for (int first = first_block; first < last_block; first += lanes) {
      const auto open = static_cast<std::uint32_t>(open_ >> first);
      const Ints block = iota(first);
      const Ints by = per_row == 8   ? shift_right<3>(block)
                      : per_row == 4 ? shift_right<2>(block)
                                     : shift_right<1>(block);
      const Ints x = shift_left<3>(block & column_mask);
      const Ints y = shift_left<3>(by);
      Ints best(0);   // negative: outside an edge
      Ints worst(0);  // negative: not wholly inside
      for (const TileEdge& e : edge_) {
        const Ints at = Ints(e.divided) + x * Ints(e.test_x) + y * Ints(e.test_y);
        best = best | (at + Ints(7 * (std::max(e.test_x, 0) + std::max(e.test_y, 0))));
        worst = worst | (at + Ints(7 * (std::min(e.test_x, 0) + std::min(e.test_y, 0))));
      }
      const std::uint32_t touched = bits(best >= Ints(0)) & open;
      touched_ |= static_cast<BlockMask>(touched) << first;
      inside_ |= static_cast<BlockMask>(bits(worst >= Ints(0)) & touched) << first;
    }
  }

  void prepare_depth() {
    slopes_ = DepthSlopes(triangle_, edge_[0]);
    if (slopes_.is_short) {
      const Ints x = load(places.x.data());
      const Ints y = load(places.y.data());
      short1_ = shift_left<8>(x * Ints(edge_[1].step_x) + y * Ints(edge_[1].step_y));
      short2_ = shift_left<8>(x * Ints(edge_[2].step_x) + y * Ints(edge_[2].step_y));
      return;
    }
    const Doubles x = to_doubles(load(places.x.data())) * Doubles(256);
    const Doubles y = to_doubles(load(places.y.data())) * Doubles(256);
    offset1_ = x * Doubles(edge_[1].step_x) + y * Doubles(edge_[1].step_y);
    offset2_ = x * Doubles(edge_[2].step_x) + y * Doubles(edge_[2].step_y);
  }

  void prepare_coverage() {
    const Ints x = load(places.x.data());
    const Ints y = load(places.y.data());
    for (std::size_t i = 0; i < 3; ++i) {
      coverage_[i] = x * Ints(edge_[i].test_x) + y * Ints(edge_[i].test_y);
    }
  }

  /// Where in a block its vector `g` begins.
  static constexpr PixelOffset first_of(std::size_t g) {
    const int pixel = static_cast<int>(g) * lanes;
    return {pixel % 8, pixel / 8};
  }

  template <bool whole>
  void draw_block(int block, Worker& worker) {
    const int x = block % tile_.blocks_per_row() * 8;
    const int y = block / tile_.blocks_per_row() * 8;
    const std::int64_t first1 = edge_[1].at(x, y);
    const std::int64_t first2 = edge_[2].at(x, y);
    const auto depth_of = [&](std::size_t g) {
      const std::int64_t e1 = first1 + edge_[1].change(first_of(g));
      const std::int64_t e2 = first2 + edge_[2].change(first_of(g));
      if (slopes_.is_short) {
        return slopes_.depth(as_numbers(Ints(static_cast<std::int32_t>(e1)) + short1_),
                             as_numbers(Ints(static_cast<std::int32_t>(e2)) + short2_));
      }
      return slopes_.depth(to_number(Doubles(static_cast<double>(e1)) + offset1_),
                           to_number(Doubles(static_cast<double>(e2)) + offset2_));
    };
    std::array<std::int32_t, 3> first_test;
    for (std::size_t i = 0; i < 3; ++i) first_test[i] = edge_[i].test_at(x, y);
    const auto covered_in = [&](std::size_t g) {
      const auto outside = [&](std::size_t i) {
        return Ints(first_test[i] + edge_[i].test_change(first_of(g))) + coverage_[i];
      };
      return (outside(0) | outside(1) | outside(2)) >= Ints(0);
    };
    float* depth_there = tile_.depth + block * 64;
    std::uint32_t* key_there = tile_.has_keys() ? tile_.key + block * 64 : nullptr;
    const Ints key(static_cast<std::int32_t>(triangle_.key));
    const auto nearer_in = [&](std::size_t g, Number depth, Number old_depth) {
      Truth nearer = depth > old_depth;
      if (key_there != nullptr) {
        nearer = nearer || (depth == old_depth && key < load(key_there + g * lanes));
      }
      if constexpr (whole) return nearer;
      return nearer && covered_in(g);
    };
    BlockMask kept = ~BlockMask{0};
    if (job_.discards()) {
      kept = 0;
      for (std::size_t g = 0; g < groups; ++g) {
        const Truth nearer = nearer_in(g, depth_of(g), load(depth_there + g * lanes));
        kept |= static_cast<BlockMask>(bits(nearer)) << (g * lanes);
      }
      kept = job_.shading->not_discarded(job_, triangle_.key, tile_.left + x, tile_.top + y, kept,
                                         worker);
    }
    Number far(3.4e38F);
    for (std::size_t g = 0; g < groups; ++g) {
      const Number old_depth = load(depth_there + g * lanes);
      if constexpr (!whole) {
        // Thin triangles miss most of the blocks they cross.
        if (!any(covered_in(g))) {
          far = minimum(far, old_depth);
          continue;
        }
      }
      const Number depth = depth_of(g);
      Truth nearer = nearer_in(g, depth, old_depth);
      if (kept != ~BlockMask{0}) {
        nearer = nearer && truth_of(static_cast<std::uint32_t>(kept >> (g * lanes)));
      }
      const Number new_depth = select(nearer, depth, old_depth);
      store(new_depth, depth_there + g * lanes);
      if (key_there != nullptr) {
        store(select(nearer, key, load(key_there + g * lanes)), key_there + g * lanes);
      }
      far = minimum(far, new_depth);
    }
    tile_.block_far[block] = smallest(far);
  }

  const DrawJob& job_;
  const Tile& tile_;
  const LargeTriangle& triangle_;
  std::array<TileEdge, 3> edge_;
  BlockMask open_;
  BlockMask touched_ = 0;
  BlockMask inside_ = 0;
  DepthSlopes slopes_;
  // Of the edge functions, over the lanes of a block's first vector.
  Doubles offset1_;
  Doubles offset2_;
  Ints short1_;
  Ints short2_;
  std::array<Ints, 3> coverage_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

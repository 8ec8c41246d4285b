// Triangles of any size, one by one in blocks of 8×8 pixels: blocks wholly outside an edge are left
// out, blocks wholly inside ask no edge.
#pragma once

#include "common/engine/plane_depths.h"

#include <optional>

namespace rasterlab::RASTERLAB_SIMD {

/// An edge function over one tile of at most 64×64 pixels.
///
/// Pixels are 256 units apart, so whether the function is at least 0 can be asked of it divided by
/// 256 and rounded down, whose steps are coordinate differences, below 2^24 in magnitude. Over a
/// tile it changes by less than 2^31; if it has both signs there, it fits 32 bits everywhere.
struct EdgeFunction {
  std::int64_t exact;   ///< at the tile's first pixel
  std::int32_t step_x;  ///< of the divided function, per pixel
  std::int32_t step_y;
  std::int32_t divided;  ///< at the tile's first pixel; all three are 0 when all the tile is inside
  std::int32_t test_x;
  std::int32_t test_y;
  bool misses;  ///< all the tile is outside

  EdgeFunction() = default;
  EdgeFunction(const LargeTriangle& t, std::size_t i, const Tile& tile) {
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

  /// Of the divided function.
  std::int32_t test_at(PixelOffset place) const { return divided + test_change(place); }
  std::int32_t test_change(PixelOffset way) const { return test_x * way.x + test_y * way.y; }
};

inline DepthPlane plane_of(const LargeTriangle& t, const std::array<EdgeFunction, 3>& edges) {
  const auto area = static_cast<double>(edges[0].step_y) * (t.y[0] - t.y[1]) +
                    static_cast<double>(edges[0].step_x) * (t.x[0] - t.x[1]);
  const double inverse = 1.0 / area;
  const double depth0 = t.depth[0];
  const auto edge = [&](std::size_t i) {
    return DepthPlane::Edge{edges[i].exact, edges[i].step_x, edges[i].step_y};
  };
  return {.key = t.key,
          // Inside, edge functions are at most twice the area: 32 bits hold them there, however
          // often they have overflown on the way.
          .is_short = area < 2147483648.0,
          .d0 = t.depth[0],
          .k1 = static_cast<float>((t.depth[1] - depth0) * inverse),
          .k2 = static_cast<float>((t.depth[2] - depth0) * inverse),
          .edge = {edge(1), edge(2)}};
}

/// Blocks in which a triangle may be seen.
inline BlockMask open_blocks(const DrawJob& job, const Tile& tile, const LargeTriangle& t,
                             float nearest, Statistics& statistics) {
  const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const auto inside = [&](int pixel) { return std::clamp(pixel, 0, tile.size - 1); };
  const int left = inside(((low_x + 127) >> 8) - tile.left);
  const int right = inside(((high_x - 128) >> 8) - tile.left);
  const int top = inside(((low_y + 127) >> 8) - tile.top);
  const int bottom = inside(((high_y - 128) >> 8) - tile.top);
  if (left > right || top > bottom) return 0;
  const BlockMask near = blocks_in_bounds(tile, left, right, top, bottom);
  return job.skip.hidden_triangles ? without_hidden(tile, near, nearest, statistics) : near;
}

class LargeDrawing {
 public:
  /// Draws into the blocks `open`, at least one.
  LargeDrawing(const DrawJob& job, const Tile& tile, const LargeTriangle& triangle, BlockMask open)
      : job_(job),
        tile_(tile),
        triangle_(triangle),
        key_(static_cast<std::int32_t>(triangle.key)),
        open_(open) {
    for (std::size_t i = 0; i < 3; ++i) edge_[i] = EdgeFunction(triangle, i, tile);
  }

  bool misses() const { return edge_[0].misses || edge_[1].misses || edge_[2].misses; }

  HWY_INLINE void draw(Worker& worker) {
    find_blocks();
    if (touched_ == 0) return;
    const DepthPlane plane = plane_of(triangle_, edge_);
    depths_.emplace(plane);
    if ((touched_ & ~inside_) != 0) prepare_coverage();
    if (tile_.undisputed != nullptr) touched_ &= ~add_to_undisputed(plane);
    give_pixels(tile_, touched_);
    for_each_block(touched_, [&](int block) {
      if ((inside_ >> block & 1U) != 0) {
        draw_block<true>(block, worker);
      } else {
        draw_block<false>(block, worker);
      }
    });
  }

 private:
  /// Which blocks may have a covered pixel, which are covered wholly.
  void find_blocks() {
    const int first_block = std::countr_zero(open_) / lanes * lanes;
    const int last_block = 64 - std::countl_zero(open_);
    for (int first = first_block; first < last_block; first += lanes) {
      const auto open = static_cast<std::uint32_t>(open_ >> first);
      const BlockCorners at_block(tile_, first);
      Ints best(0);   // negative: outside an edge
      Ints worst(0);  // negative: not wholly inside
      for (const EdgeFunction& e : edge_) {
        const Ints at = Ints(e.divided) + at_block.x * Ints(e.test_x) + at_block.y * Ints(e.test_y);
        best = best | (at + Ints(7 * (std::max(e.test_x, 0) + std::max(e.test_y, 0))));
        worst = worst | (at + Ints(7 * (std::min(e.test_x, 0) + std::min(e.test_y, 0))));
      }
      const std::uint32_t touched = bits(best >= Ints(0)) & open;
      touched_ |= static_cast<BlockMask>(touched) << first;
      inside_ |= static_cast<BlockMask>(bits(worst >= Ints(0)) & touched) << first;
    }
  }

  void prepare_coverage() {
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeFunction& edge = edge_[i];
      coverage_[i] = BlockSteps<Ints>(
          [&](PixelOffset way) { return edge.test_change(way); },
          load(places.x.data()) * Ints(edge.test_x) + load(places.y.data()) * Ints(edge.test_y));
    }
  }

  /// Draws into the undisputed blocks that stay so. Returns which needn't be drawn into any more.
  /// A part of draw(), which has what it needs in registers: called, it costs 3 % of a frame.
  HWY_INLINE BlockMask add_to_undisputed(const DepthPlane& plane) const {
    UndisputedBlocks& undisputed = *tile_.undisputed;
    const BlockMask blocks = touched_ & undisputed.mask();
    const DepthBounds<float> bounds = bounds_of(triangle_.depth);
    if (blocks == 0 || bounds.far <= 0) return 0;
    alignas(64) std::array<float, 64> far;
    alignas(64) std::array<float, 64> near;
    bound_whole_blocks(blocks & inside_, far.data(), near.data());
    const std::int32_t number = undisputed.add_plane(plane);
    BlockMask done = 0;
    for_each_block(blocks, [&](int block) {
      const auto b = static_cast<std::size_t>(block);
      const bool whole = (inside_ >> block & 1U) != 0;
      const BlockMask pixels = whole ? all_64 : covered_pixels(block);
      const DepthBounds<float> depths = whole ? DepthBounds<float>{far[b], near[b]} : bounds;
      if (pixels == 0 || undisputed.add(block, pixels, depths, number, tile_.block_far[block])) {
        done |= BlockMask{1} << block;
      }
    });
    return done;
  }

  void bound_whole_blocks(BlockMask blocks, float* far, float* near) const {
    for (int first = 0; first < tile_.block_count(); first += lanes) {
      if (lanes_at(blocks, first) == 0) continue;
      const BlockCorners corners(tile_, first);
      const auto bounds = depths_->in_blocks(corners.x, corners.y);
      store(bounds.far, far + first);
      store(bounds.near, near + first);
    }
  }

  /// Which of a block's pixels are covered, vector by vector.
  struct CoverageWalk {
    const std::array<BlockSteps<Ints>, 3>& steps;
    std::array<Ints, 3> test;

    Truth covered() const { return (test[0] | test[1] | test[2]) >= Ints(0); }
    /// From vector `g` to the next.
    void move_on(int g) {
      for (std::size_t i = 0; i < 3; ++i) test[i] = steps[i].after(g, test[i]);
    }
  };

  CoverageWalk coverage_in(int block) const {
    const PixelOffset corner = place_of_block(tile_, block);
    CoverageWalk walk = {coverage_, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      walk.test[i] = Ints(edge_[i].test_at(corner)) + coverage_[i].first;
    }
    return walk;
  }

  BlockMask covered_pixels(int block) const {
    CoverageWalk walk = coverage_in(block);
    BlockMask pixels = 0;
    for (int g = 0; g < groups; ++g) {
      pixels |= BlockMask{bits(walk.covered())} << (g * lanes);
      walk.move_on(g);
    }
    return pixels;
  }

  /// Calls `visit(place, covered, depth)` for each vector of a block's pixels, `place` being its
  /// own in the tile's arrays.
  template <bool whole, class Visit>
  void for_each_vector(int block, const Visit& visit) const {
    const PixelOffset corner = place_of_block(tile_, block);
    if constexpr (whole) {
      const Truth covered = Ints(0) == Ints(0);
      depths_->for_each_vector(
          corner, [&](int g, Number depth) { visit(block * 64 + g * lanes, covered, depth); });
    } else {
      CoverageWalk walk = coverage_in(block);
      depths_->for_each_vector(corner, [&](int g, Number depth) {
        visit(block * 64 + g * lanes, walk.covered(), depth);
        walk.move_on(g);
      });
    }
  }

  Truth is_nearer(int place, Truth covered, Number depth) const {
    const Number old_depth = load(tile_.depth + place);
    Truth nearer = depth > old_depth;
    if (tile_.has_keys()) {
      nearer = nearer || (depth == old_depth && key_ < load(tile_.key + place));
    }
    return nearer && covered;
  }

  template <bool whole>
  void draw_block(int block, Worker& worker) {
    const BlockMask kept = job_.shades_blocks() ? shade<whole>(block, worker) : all_64;
    Number far(3.4e38F);
    for_each_vector<whole>(block, [&](int place, Truth covered, Number depth) {
      Truth nearer = is_nearer(place, covered, depth);
      if (kept != all_64) nearer = nearer && truth_of(lanes_at(kept, place & 63));
      const Number new_depth = select(nearer, depth, load(tile_.depth + place));
      store(new_depth, tile_.depth + place);
      if (tile_.has_keys()) {
        store(select(nearer, key_, load(tile_.key + place)), tile_.key + place);
      }
      far = minimum(far, new_depth);
    });
    tile_.block_far[block] = smallest(far);
  }

  /// Has the pixels shaded that are to be drawn, and returns those that aren't discarded.
  template <bool whole>
  BlockMask shade(int block, Worker& worker) const {
    BlockMask nearer = 0;
    for_each_vector<whole>(block, [&](int place, Truth covered, Number depth) {
      nearer |= BlockMask{bits(is_nearer(place, covered, depth))} << (place & 63);
    });
    if (nearer == 0) return 0;
    return job_.shading->shade_now(job_, block_of_picture(block), triangle_.key, nearer, worker);
  }

  /// As a tile by itself, with a place for colours if these are wanted now.
  Tile block_of_picture(int block) const {
    const PixelOffset corner = place_of_block(tile_, block);
    Tile alone;
    alone.left = tile_.left + corner.x;
    alone.top = tile_.top + corner.y;
    alone.size = 8;
    alone.width = std::clamp(tile_.width - corner.x, 0, 8);
    alone.height = std::clamp(tile_.height - corner.y, 0, 8);
    alone.stride = tile_.stride;
    if (job_.colors_blocks()) alone.color = tile_.color + corner.y * tile_.stride + corner.x;
    return alone;
  }

  const DrawJob& job_;
  const Tile& tile_;
  const LargeTriangle& triangle_;
  Ints key_;
  std::array<EdgeFunction, 3> edge_;
  BlockMask open_;
  BlockMask touched_ = 0;
  BlockMask inside_ = 0;
  std::optional<PlaneDepths> depths_;  ///< made where it stays: it is large
  std::array<BlockSteps<Ints>, 3> coverage_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

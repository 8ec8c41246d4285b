// Triangles of up to 63 pixels a side: set up side by side, one per lane, and then drawn one after
// the other, in blocks of 8×8 pixels, or, those of few pixels, vector by vector
// (compact_triangle.h). Their edge functions fit 32 bits in all the tile.
#pragma once

#include "common/engine/compact_triangle.h"
#include "common/engine/nearest_pixels.h"
#include "common/engine/plane_depths.h"

namespace rasterlab::RASTERLAB_SIMD {

/// One of them, block by block.
class MediumTriangle {
 public:
  MediumTriangle(const Tile& tile, const MediumLanes& t, std::size_t lane, std::uint32_t key)
      : tile_(tile),
        left_(t.left[lane]),
        right_(t.right[lane]),
        top_(t.top[lane]),
        bottom_(t.bottom[lane]),
        nearest_(tile, key),
        bounds_{t.far[lane], t.near[lane]},
        plane_{.key = key,
               .is_short = true,
               .d0 = t.d0[lane],
               .k1 = t.k1[lane],
               .k2 = t.k2[lane],
               .edge = {plane_edge(t, lane, 1), plane_edge(t, lane, 2)}},
        d0_(plane_.d0),
        k1_(plane_.k1),
        k2_(plane_.k2) {
    const Ints x = load(places.x.data());
    const Ints y = load(places.y.data());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t step_x = t.step_x[i][lane];
      const std::int32_t step_y = t.step_y[i][lane];
      edge_[i] = {t.value[i][lane], step_x, step_y, 7 * (std::max(step_x, 0) + std::max(step_y, 0)),
                  BlockSteps<Ints>([&](PixelOffset way) { return way.x * step_x + way.y * step_y; },
                                   x * Ints(step_x) + y * Ints(step_y))};
    }
    lessened1_ = Ints(t.lessened[1][lane]);
    lessened2_ = Ints(t.lessened[2][lane]);
  }

  /// Returns which of the blocks, all within its bounds, it was drawn into.
  BlockMask draw(BlockMask blocks) {
    BlockMask drawn = 0;
    for (int y = top_ & ~7; y <= bottom_; y += 8) {
      std::array<std::int32_t, 3> value = values_at(left_ & ~7, y);
      for (int x = left_ & ~7; x <= right_; x += 8) {
        const int block = tile_.block_at(x, y);
        if ((blocks >> block & 1U) != 0 && reaches(value) && draw_block(block, y, value)) {
          drawn |= BlockMask{1} << block;
        }
        for (std::size_t i = 0; i < 3; ++i) value[i] += 8 * edge_[i].step_x;
      }
    }
    return drawn;
  }

 private:
  struct Edge {
    std::int32_t value, step_x, step_y;
    std::int32_t to_best;  ///< from a block's first pixel to where in it the function is largest
    BlockSteps<Ints> steps;
  };

  static DepthPlane::Edge plane_edge(const MediumLanes& t, std::size_t lane, std::size_t i) {
    return {t.value[i][lane] + t.lessened[i][lane], t.step_x[i][lane] / 256,
            t.step_y[i][lane] / 256};
  }

  std::array<std::int32_t, 3> values_at(int x, int y) const {
    std::array<std::int32_t, 3> value;
    for (std::size_t i = 0; i < 3; ++i) {
      value[i] = edge_[i].value + x * edge_[i].step_x + y * edge_[i].step_y;
    }
    return value;
  }

  /// Whether no edge has all of a block outside, whose first pixel has these values.
  bool reaches(const std::array<std::int32_t, 3>& value) const {
    return ((value[0] + edge_[0].to_best) | (value[1] + edge_[1].to_best) |
            (value[2] + edge_[2].to_best)) >= 0;
  }

  /// Calls `visit(g, covered, edges)` for the vectors of a block that may have a covered pixel.
  template <class Visit>
  void for_each_vector(int y, const std::array<std::int32_t, 3>& value, const Visit& visit) const {
    const int first = std::max(top_ - y, 0) * 8 / lanes;
    const int last = (std::min(bottom_ - y, 7) * 8 + 7) / lanes;
    std::array<Ints, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge& edge = edge_[i];
      const std::int32_t change = first * lanes % 8 * edge.step_x + first * lanes / 8 * edge.step_y;
      e[i] = Ints(value[i] + change) + edge.steps.first;
    }
    for (int g = first; g <= last; ++g) {
      visit(g, (e[0] | e[1] | e[2]) >= Ints(0), e);
      for (std::size_t i = 0; i < 3; ++i) e[i] = edge_[i].steps.after(g, e[i]);
    }
  }

  /// False when none of its pixels are given a depth.
  bool draw_block(int block, int y, const std::array<std::int32_t, 3>& value) {
    if (tile_.undisputed != nullptr && tile_.undisputed->has(block)) {
      if (add_to_undisputed(block, y, value)) return false;
      give_pixels(tile_, BlockMask{1} << block);
    }
    bool drawn = false;
    for_each_vector(y, value, [&](int g, Truth covered, const std::array<Ints, 3>& e) {
      if (!any(covered)) return;
      drawn = true;
      nearest_.write(
          block * 64 + g * lanes, covered,
          d0_ + (as_numbers(e[1] + lessened1_) * k1_ + as_numbers(e[2] + lessened2_) * k2_));
    });
    return drawn;
  }

  /// True when there is nothing more to do.
  bool add_to_undisputed(int block, int y, const std::array<std::int32_t, 3>& value) {
    BlockMask pixels = 0;
    for_each_vector(y, value, [&](int g, Truth covered, const std::array<Ints, 3>&) {
      pixels |= BlockMask{bits(covered)} << (g * lanes);
    });
    if (pixels == 0) return true;
    if (bounds_.far <= 0) return false;
    if (plane_number_ < 0) plane_number_ = tile_.undisputed->add_plane(plane_);
    return tile_.undisputed->add(block, pixels, bounds_, plane_number_, tile_.block_far[block]);
  }

  const Tile& tile_;
  int left_, right_, top_, bottom_;
  NearestPixels nearest_;
  DepthBounds<float> bounds_;
  DepthPlane plane_;
  std::int32_t plane_number_ = -1;  ///< of the tile's undisputed blocks
  Number d0_, k1_, k2_;
  std::array<Edge, 3> edge_;
  Ints lessened1_, lessened2_;
};

inline void draw_medium(const Tile& tile, const PackedTriangles& triangles, bool skip_hidden,
                        Statistics& statistics) {
  for (int from = 0; from < triangles.count; from += lanes) {
    const MediumLanes t(triangles, from, tile);
    BlockMask drawn = 0;
    const int count = std::min(triangles.count - from, lanes);
    for (int i = 0; i < count; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (t.left[lane] > t.right[lane] || t.top[lane] > t.bottom[lane]) continue;
      const BlockMask reached =
          blocks_in_bounds(tile, t.left[lane], t.right[lane], t.top[lane], t.bottom[lane]);
      BlockMask open = reached;
      if (skip_hidden) open = without_hidden(tile, open, t.near[lane], statistics);
      if (open == 0) continue;
      const std::uint32_t key = triangles.triangle[static_cast<std::size_t>(from) + lane].key;
      if (CompactTriangle::is_one(t, lane) && have_pixels(tile, reached)) {
        CompactTriangle(tile, t, lane, key).draw();
        drawn |= reached;
        continue;
      }
      drawn |= MediumTriangle(tile, t, lane, key).draw(open);
    }
    update_far(tile, drawn);
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD

// A triangle of few pixels, drawn vector by vector.
//
// With a handful of vectors in its bounds, to ask for each, or for a block of them, whether the
// triangle covers any of it costs more than drawing it: no processor guesses the answer. So all of
// them are drawn, and no branch depends on where the triangle is but the ends of two short loops.
#pragma once

#include "common/engine/blocks.h"
#include "common/engine/medium_lanes.h"
#include "common/engine/nearest_pixels.h"

namespace rasterlab::RASTERLAB_SIMD {

class CompactTriangle {
 public:
  static bool is_one(const MediumLanes& t, std::size_t lane) {
    constexpr int most = PackedTriangles::max_compact_side;
    return t.right[lane] - t.left[lane] < most && t.bottom[lane] - t.top[lane] < most;
  }

  /// In a tile whose pixels it may reach all have a depth.
  CompactTriangle(const Tile& tile, const MediumLanes& t, std::size_t lane, std::uint32_t key)
      : blocks_per_row_(static_cast<unsigned>(tile.blocks_per_row())),
        left_(t.left[lane] & -columns),
        right_(t.right[lane]),
        top_(t.top[lane] & -rows),
        bottom_(t.bottom[lane]),
        nearest_(tile, key),
        d0_(t.d0[lane]),
        k1_(t.k1[lane]),
        k2_(t.k2[lane]),
        lessened1_(t.lessened[1][lane]),
        lessened2_(t.lessened[2][lane]) {
    const Ints x = load(places.x.data());
    const Ints y = load(places.y.data());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t step_x = t.step_x[i][lane];
      const std::int32_t step_y = t.step_y[i][lane];
      edge_[i] = {Ints(t.value[i][lane] + left_ * step_x + top_ * step_y) +
                      (x * Ints(step_x) + y * Ints(step_y)),
                  Ints(columns * step_x), Ints(rows * step_y)};
    }
  }

  void draw() const {
    std::array<Ints, 3> top = {edge_[0].first, edge_[1].first, edge_[2].first};
    for (int x = left_; x <= right_; x += columns) {
      std::array<Ints, 3> e = top;
      for (int y = top_; y <= bottom_; y += rows) {
        draw_vector(place_of(static_cast<unsigned>(x), static_cast<unsigned>(y)), e);
        for (std::size_t i = 0; i < 3; ++i) e[i] = e[i] + edge_[i].down;
      }
      for (std::size_t i = 0; i < 3; ++i) top[i] = top[i] + edge_[i].right;
    }
  }

 private:
  /// What of a block a vector is.
  static constexpr int columns = std::min(lanes, 8);
  static constexpr int rows = lanes / columns;

  /// In the tile's arrays.
  int place_of(unsigned x, unsigned y) const {
    return static_cast<int>((y / 8 * blocks_per_row_ + x / 8) * 64 + y % 8 * 8 + x % 8);
  }

  struct Edge {
    Ints first;        ///< its function in the first vector
    Ints right, down;  ///< how much it changes to the next one
  };

  void draw_vector(int place, const std::array<Ints, 3>& e) const {
    const Truth covered = (e[0] | e[1] | e[2]) >= Ints(0);
    nearest_.write(
        place, covered,
        d0_ + (as_numbers(e[1] + lessened1_) * k1_ + as_numbers(e[2] + lessened2_) * k2_));
  }

  unsigned blocks_per_row_;
  int left_, right_, top_, bottom_;
  NearestPixels nearest_;
  Number d0_, k1_, k2_;
  Ints lessened1_, lessened2_;
  std::array<Edge, 3> edge_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

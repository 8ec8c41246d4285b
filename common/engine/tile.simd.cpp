// The back end: depth and triangle of every pixel of a tile.
//
// Two ways to draw. Triangles of a few pixels are drawn one per lane, all 16 walking over their own
// pixels at the same time; what they hit goes to the depth buffer one by one. Larger ones are drawn
// one after the other, in blocks of 8×8 pixels: blocks wholly outside an edge are left out, blocks
// wholly inside ask no edge.
//
// Both compute the same numbers for a pixel. Edge functions are integers, exactly; depth is
// d0 + (E1·k1 + E2·k2), where E is the edge function rounded to float once and k = (di − d0) / area
// rounded to float once: within 5 half units in the last place of the largest corner's depth,
// however thin the triangle.
#include "common/engine/kernels.h"
#include "common/engine/simd.h"
#include "common/engine/simd_kernels.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace rasterlab::RASTERLAB_SIMD {

namespace {

constexpr int groups = 64 / lanes;  // vectors in a block

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
constexpr BlockPlaces places;

// ---------------------------------------------------------------------------------------------
// Small triangles, one per lane

/// E0, E1, E2 of as many triangles as there are lanes. Small: 32 bit hold every product.
struct LaneEdge {
  Ints value;  ///< at the current pixel, less what makes the boundary belong elsewhere
  Ints step_x;
  Ints step_y;
  Ints lessened;  ///< 0 or 1: by how much

  LaneEdge(Ints ax, Ints ay, Ints bx, Ints by, Ints px, Ints py) {
    const Ints dx = bx - ax;
    const Ints dy = by - ay;
    step_x = shift_left<8>(Ints(0) - dy);
    step_y = shift_left<8>(dx);
    const Truth owns = step_x > Ints(0) || (step_x == Ints(0) && step_y > Ints(0));
    lessened = select(owns, Ints(0), Ints(1));
    value = dx * (py - ay) - dy * (px - ax) - lessened;
  }
};

/// As many triangles as there are lanes, ready to walk over.
struct LaneTriangles {
  std::array<LaneEdge, 3> edge;
  Ints left, top;      ///< the first pixel of the tile
  Ints columns, rows;  ///< pixels to walk over, less one; −1 in lanes without a triangle
  Number depth, k1, k2;
};

/// Which lanes' triangles are behind all that the blocks they touch already show. A triangle of at
/// most 8×8 samples touches no block but those of its corners.
Truth hidden_lanes(const Tile& tile, Ints left, Ints right, Ints top, Ints bottom, Number nearest) {
  const Ints per_row(tile.blocks_per_row());
  const Ints last(tile.blocks_per_row() - 1);
  const auto block = [&](Ints pixel) {
    return minimum(maximum(shift_right<3>(pixel), Ints(0)), last);
  };
  const auto far = [&](Ints x, Ints y) { return gather_numbers(tile.block_far, y * per_row + x); };
  const Number above = minimum(far(block(left), block(top)), far(block(right), block(top)));
  const Number below = minimum(far(block(left), block(bottom)), far(block(right), block(bottom)));
  return minimum(above, below) > nearest * Number(1.000001F);
}

LaneTriangles load_lanes(const SmallTriangles& triangles, int from, int count, const Tile& tile,
                         bool skip_hidden) {
  std::array<Ints, 3> x;
  std::array<Ints, 3> y;
  for (std::size_t i = 0; i < 3; ++i) {
    const Ints packed = load(triangles.corner[i].data() + from);
    x[i] = shift_right<16>(shift_left<16>(packed));
    y[i] = shift_right<16>(packed);
  }
  const Ints low_x = minimum(minimum(x[0], x[1]), x[2]);
  const Ints high_x = maximum(maximum(x[0], x[1]), x[2]);
  const Ints low_y = minimum(minimum(y[0], y[1]), y[2]);
  const Ints high_y = maximum(maximum(y[0], y[1]), y[2]);
  const Ints left = maximum(shift_right<8>(low_x + Ints(127)), Ints(0));
  const Ints right = minimum(shift_right<8>(high_x - Ints(128)), Ints(tile.width - 1));
  const Ints top = maximum(shift_right<8>(low_y + Ints(127)), Ints(0));
  const Ints bottom = minimum(shift_right<8>(high_y - Ints(128)), Ints(tile.height - 1));
  const Ints px = shift_left<8>(left) + Ints(128);
  const Ints py = shift_left<8>(top) + Ints(128);
  const Ints area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
  const Doubles inverse = Doubles(1) / to_doubles(area);
  const Number d0 = load(triangles.depth[0].data() + from);
  const Number d1 = load(triangles.depth[1].data() + from);
  const Number d2 = load(triangles.depth[2].data() + from);
  Truth present = first_lanes(std::min(count, lanes));
  if (skip_hidden) {
    const Number nearest = maximum(maximum(d0, d1), d2);
    present = present && !hidden_lanes(tile, left, right, top, bottom, nearest);
  }
  return {{LaneEdge(x[1], y[1], x[2], y[2], px, py), LaneEdge(x[2], y[2], x[0], y[0], px, py),
           LaneEdge(x[0], y[0], x[1], y[1], px, py)},
          left,
          top,
          select(present, right - left, Ints(-1)),
          select(present, bottom - top, Ints(-1)),
          d0,
          to_number((to_doubles(d1) - to_doubles(d0)) * inverse),
          to_number((to_doubles(d2) - to_doubles(d0)) * inverse)};
}

/// Draws hits into a tile one by one.
class HitWriter {
 public:
  explicit HitWriter(const Tile& tile) : tile_(tile) {}

  /// Lanes of `hit` at tile pixel `pixel`.
  void write(std::uint32_t hit, Ints pixel, Number depth, const std::uint32_t* key) {
    alignas(64) std::array<std::int32_t, lanes> pixel_of;
    alignas(64) std::array<float, lanes> depth_of;
    store(pixel, pixel_of.data());
    store(depth, depth_of.data());
    for (; hit != 0; hit &= hit - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(hit));
      const std::int32_t p = pixel_of[lane];
      const float d = depth_of[lane];
      if (d > tile_.depth[p] || (d == tile_.depth[p] && key[lane] < tile_.key[p])) {
        tile_.depth[p] = d;
        tile_.key[p] = key[lane];
        written_ |= BlockMask{1} << (p >> 6);
      }
    }
  }

  /// Blocks written to since the last call.
  BlockMask take_written_blocks() { return std::exchange(written_, 0); }

 private:
  const Tile& tile_;
  BlockMask written_ = 0;
};

void draw_lanes(const Tile& tile, LaneTriangles t, const std::uint32_t* key, HitWriter& writer) {
  const std::int32_t columns = largest(t.columns);
  const std::int32_t rows = largest(t.rows);
  const Ints block_row(64 * tile.blocks_per_row() - 64);
  for (std::int32_t row = 0; row <= rows; ++row) {
    std::array<Ints, 3> e = {t.edge[0].value, t.edge[1].value, t.edge[2].value};
    const Ints y = t.top + Ints(row);
    for (std::int32_t column = 0; column <= columns; ++column) {
      // Negative: outside an edge, or beyond the lane's own pixels.
      const Ints outside =
          (e[0] | e[1] | e[2]) | ((t.columns - Ints(column)) | (t.rows - Ints(row)));
      const std::uint32_t hit = bits(outside >= Ints(0));
      if (hit != 0) {
        const Ints x = t.left + Ints(column);
        const Number depth = t.depth + (as_numbers(e[1] + t.edge[1].lessened) * t.k1 +
                                        as_numbers(e[2] + t.edge[2].lessened) * t.k2);
        const Ints pixel =
            (x + shift_right<3>(x) * Ints(56)) + (shift_left<3>(y) + shift_right<3>(y) * block_row);
        writer.write(hit, pixel, depth, key);
      }
      for (std::size_t i = 0; i < 3; ++i) e[i] = e[i] + t.edge[i].step_x;
    }
    for (LaneEdge& edge : t.edge) edge.value = edge.value + edge.step_y;
  }
}

void draw_small(const Tile& tile, const SmallTriangles& triangles, bool skip_hidden,
                HitWriter& writer) {
  for (int from = 0; from < triangles.count; from += lanes) {
    draw_lanes(tile, load_lanes(triangles, from, triangles.count - from, tile, skip_hidden),
               triangles.key.data() + from, writer);
  }
}

// ---------------------------------------------------------------------------------------------
// Large triangles, one by one in blocks of 8×8

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
};

class LargeDrawing {
 public:
  LargeDrawing(const DrawJob& job, const Tile& tile, const LargeTriangle& triangle)
      : job_(job), tile_(tile), triangle_(triangle) {
    for (std::size_t i = 0; i < 3; ++i) edge_[i] = TileEdge(triangle, i, tile);
    const auto [low_x, high_x] = std::minmax({triangle.x[0], triangle.x[1], triangle.x[2]});
    const auto [low_y, high_y] = std::minmax({triangle.y[0], triangle.y[1], triangle.y[2]});
    left_ = ((low_x + 127) >> 8) - tile.left;
    right_ = ((high_x - 128) >> 8) - tile.left;
    top_ = ((low_y + 127) >> 8) - tile.top;
    bottom_ = ((high_y - 128) >> 8) - tile.top;
  }

  bool misses() const { return edge_[0].misses || edge_[1].misses || edge_[2].misses; }

  void draw(Worker& worker) {
    find_blocks(worker.statistics);
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
  void find_blocks(Statistics& statistics) {
    const int per_row = tile_.blocks_per_row();
    const Ints shift_mask(per_row - 1);
    const float nearest =
        std::max({triangle_.depth[0], triangle_.depth[1], triangle_.depth[2]}) * 1.000001F;
    const int first_block = std::max(top_ / 8, 0) * per_row / lanes * lanes;
    const int last_block = (std::min(bottom_, tile_.size - 1) / 8 + 1) * per_row;
    for (int first = first_block; first < last_block; first += lanes) {
      const Ints block = iota(first);
      const Ints bx = block & shift_mask;
      const Ints by = per_row == 8   ? shift_right<3>(block)
                      : per_row == 4 ? shift_right<2>(block)
                                     : shift_right<1>(block);
      const Ints x = shift_left<3>(bx);
      const Ints y = shift_left<3>(by);
      Ints best(0);   // negative: outside an edge
      Ints worst(0);  // negative: not wholly inside
      for (const TileEdge& e : edge_) {
        const Ints at = Ints(e.divided) + x * Ints(e.test_x) + y * Ints(e.test_y);
        best = best | (at + Ints(7 * (std::max(e.test_x, 0) + std::max(e.test_y, 0))));
        worst = worst | (at + Ints(7 * (std::min(e.test_x, 0) + std::min(e.test_y, 0))));
      }
      const Truth present = first_lanes(std::min(lanes, tile_.block_count() - first));
      Truth touched = best >= Ints(0) && present && in_bounds(x, y);
      if (job_.skip.hidden) {
        const Truth hidden = touched && load(tile_.block_far + first) > Number(nearest);
        statistics.blocks_hidden += static_cast<unsigned>(std::popcount(bits(hidden)));
        touched = touched && !hidden;
      }
      touched_ |= static_cast<BlockMask>(bits(touched)) << first;
      inside_ |= static_cast<BlockMask>(bits(touched && worst >= Ints(0))) << first;
    }
  }

  /// Whether blocks reach into the box around the triangle.
  Truth in_bounds(Ints x, Ints y) const {
    return x + Ints(7) >= Ints(left_) && x <= Ints(right_) && y + Ints(7) >= Ints(top_) &&
           y <= Ints(bottom_);
  }

  /// Within 64 pixels a side: edge functions over the tile fit 32 bits as they are.
  bool is_short() const { return right_ - left_ < 63 && bottom_ - top_ < 63; }

  void prepare_depth() {
    const auto area = static_cast<double>(edge_[0].step_y) * (triangle_.y[0] - triangle_.y[1]) +
                      static_cast<double>(edge_[0].step_x) * (triangle_.x[0] - triangle_.x[1]);
    const double inverse = 1.0 / area;
    const double d0 = triangle_.depth[0];
    k1_ = static_cast<float>((triangle_.depth[1] - d0) * inverse);
    k2_ = static_cast<float>((triangle_.depth[2] - d0) * inverse);
    short_ = is_short();
    if (short_) {
      const Ints x = shift_left<8>(load(places.x.data()));
      const Ints y = shift_left<8>(load(places.y.data()));
      short1_ = x * Ints(edge_[1].step_x) + y * Ints(edge_[1].step_y);
      short2_ = x * Ints(edge_[2].step_x) + y * Ints(edge_[2].step_y);
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

  /// Exact, in a double, at the block's first pixel.
  static std::int32_t short_at(const TileEdge& edge, int x, int y) {
    return static_cast<std::int32_t>(edge.exact) + 256 * (edge.step_x * x + edge.step_y * y);
  }
  static double exact_at(const TileEdge& edge, int x, int y) {
    return static_cast<double>(edge.exact) +
           256.0 * (static_cast<double>(edge.step_x) * x + static_cast<double>(edge.step_y) * y);
  }

  struct Offset {
    int x, y;
  };
  /// Where in a block its vector `g` begins.
  static constexpr Offset first_of(std::size_t g) {
    const int pixel = static_cast<int>(g) * lanes;
    return {pixel % 8, pixel / 8};
  }

  template <bool whole>
  void draw_block(int block, Worker& worker) {
    const int x = block % tile_.blocks_per_row() * 8;
    const int y = block / tile_.blocks_per_row() * 8;
    const auto depth_of = [&](std::size_t g) {
      const auto [gx, gy] = first_of(g);
      if (short_) {
        const Ints e1 = Ints(short_at(edge_[1], x + gx, y + gy)) + short1_;
        const Ints e2 = Ints(short_at(edge_[2], x + gx, y + gy)) + short2_;
        return Number(triangle_.depth[0]) +
               (as_numbers(e1) * Number(k1_) + as_numbers(e2) * Number(k2_));
      }
      const Doubles e1 = Doubles(exact_at(edge_[1], x + gx, y + gy)) + offset1_;
      const Doubles e2 = Doubles(exact_at(edge_[2], x + gx, y + gy)) + offset2_;
      return Number(triangle_.depth[0]) +
             (to_number(e1) * Number(k1_) + to_number(e2) * Number(k2_));
    };
    const auto covered_in = [&](std::size_t g) {
      const auto first = first_of(g);
      const int group_x = x + first.x;
      const int group_y = y + first.y;
      const auto outside = [&](const TileEdge& e, Ints offset) {
        return Ints(e.divided + e.test_x * group_x + e.test_y * group_y) + offset;
      };
      return (outside(edge_[0], coverage_[0]) | outside(edge_[1], coverage_[1]) |
              outside(edge_[2], coverage_[2])) >= Ints(0);
    };
    float* depth_there = tile_.depth + block * 64;
    std::uint32_t* key_there = tile_.key + block * 64;
    const Ints key(static_cast<std::int32_t>(triangle_.key));
    const auto nearer_in = [&](std::size_t g, Number depth, Number old_depth, Ints old_key) {
      const Truth nearer = depth > old_depth || (depth == old_depth && key < old_key);
      if constexpr (whole) return nearer;
      return nearer && covered_in(g);
    };
    BlockMask kept = ~BlockMask{0};
    if (job_.discards()) {
      kept = 0;
      for (std::size_t g = 0; g < groups; ++g) {
        const Truth nearer =
            nearer_in(g, depth_of(g), load(depth_there + g * lanes), load(key_there + g * lanes));
        kept |= static_cast<BlockMask>(bits(nearer)) << (g * lanes);
      }
      kept = job_.shading->keep(job_, triangle_.key, tile_.left + x, tile_.top + y, kept, worker);
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
      const Ints old_key = load(key_there + g * lanes);
      Truth nearer = nearer_in(g, depth, old_depth, old_key);
      if (kept != ~BlockMask{0}) {
        nearer = nearer && truth_of(static_cast<std::uint32_t>(kept >> (g * lanes)));
      }
      const Number new_depth = select(nearer, depth, old_depth);
      store(new_depth, depth_there + g * lanes);
      store(select(nearer, key, old_key), key_there + g * lanes);
      far = minimum(far, new_depth);
    }
    tile_.block_far[block] = smallest(far);
  }

  const DrawJob& job_;
  const Tile& tile_;
  const LargeTriangle& triangle_;
  std::array<TileEdge, 3> edge_;
  int left_, right_, top_, bottom_;  ///< pixels of the tile within the box around the triangle
  BlockMask touched_ = 0;
  BlockMask inside_ = 0;
  float k1_ = 0;
  float k2_ = 0;
  // Of the edge functions, over the lanes of a block's first vector.
  Doubles offset1_;
  Doubles offset2_;
  Ints short1_;
  Ints short2_;
  bool short_ = false;
  std::array<Ints, 3> coverage_;
};

// ---------------------------------------------------------------------------------------------
// Thin triangles: rows (or columns) of the tile side by side, one per lane
//
// A sliver crosses many blocks and has a sample or two in each row. Here each lane takes a row, if
// the sliver is steep, or a column, if it is flat, and walks the few pixels between its longest
// side and its third corner.

class ThinDrawing {
 public:
  ThinDrawing(const Tile& tile, const LargeTriangle& triangle, HitWriter& writer)
      : tile_(tile), triangle_(triangle), writer_(writer) {}

  /// Pixels to walk at most, in each row or column, for a triangle to be worth this.
  static constexpr float most_steps = 6;

  /// False when the triangle isn't thin: nothing is drawn then.
  bool draw() {
    find_spine();
    if (!(steps_ <= most_steps)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      edge_[i] = TileEdge(triangle_, i, tile_);
      if (edge_[i].misses) return true;
    }
    const double area = static_cast<double>(edge_[0].step_y) * (triangle_.y[0] - triangle_.y[1]) +
                        static_cast<double>(edge_[0].step_x) * (triangle_.x[0] - triangle_.x[1]);
    const double inverse = 1.0 / area;
    const double d0 = triangle_.depth[0];
    k1_ = Number(static_cast<float>((triangle_.depth[1] - d0) * inverse));
    k2_ = Number(static_cast<float>((triangle_.depth[2] - d0) * inverse));
    const auto& major = steep_ ? triangle_.y : triangle_.x;
    const int origin = steep_ ? tile_.top : tile_.left;
    const auto [low, high] = std::minmax({major[0], major[1], major[2]});
    const int first = std::max(((low + 127) >> 8) - origin, 0);
    const int last = std::min(((high - 128) >> 8) - origin, tile_.size - 1);
    for (int line = first; line <= last; line += lanes) draw_lines(line, last);
    return true;
  }

 private:
  /// The longest side, seen along the axis it reaches farthest on: pixel position across that axis
  /// is base_ + slope_ · line, and the triangle lies between that and offset_ pixels beside it.
  void find_spine() {
    std::size_t from = 0;
    std::int32_t longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::int32_t length = std::max(std::abs(triangle_.x[j] - triangle_.x[i]),
                                           std::abs(triangle_.y[j] - triangle_.y[i]));
      if (length > longest) {
        longest = length;
        from = i;
      }
    }
    const std::size_t to = (from + 1) % 3;
    const std::size_t third = (from + 2) % 3;
    steep_ = std::abs(triangle_.y[to] - triangle_.y[from]) == longest;
    const auto& major = steep_ ? triangle_.y : triangle_.x;
    const auto& minor = steep_ ? triangle_.x : triangle_.y;
    const auto along = static_cast<float>(major[to] - major[from]);
    slope_ = static_cast<float>(minor[to] - minor[from]) / along;
    const int major_origin = steep_ ? tile_.top : tile_.left;
    const int minor_origin = steep_ ? tile_.left : tile_.top;
    // Pixel centres are half a pixel on: 128 units.
    const auto to_first = static_cast<float>(major_origin * 256 + 128 - major[from]);
    base_ = (static_cast<float>(minor[from] - minor_origin * 256 - 128) + to_first * slope_) / 256;
    const float offset = (static_cast<float>(minor[third] - minor[from]) -
                          static_cast<float>(major[third] - major[from]) * slope_) /
                         256;
    // Room for rounding: positions are below 2^17 pixels here, and asked for near the tile.
    start_ = std::min(offset, 0.0F) - 0.75F;
    steps_ = std::abs(offset) + 2.5F;
  }

  void draw_lines(int first, int last) {
    const Ints line = iota(first);
    const Number place = Number(base_) + Number(slope_) * as_numbers(line) + Number(start_);
    // Far outside the tile, rounding is coarser but nothing is drawn either.
    const Number bounded = minimum(maximum(place, Number(-16)), Number(80));
    Ints across = to_whole(round_down(bounded));
    const Ints& x = steep_ ? across : line;
    const Ints& y = steep_ ? line : across;
    std::array<Ints, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = Ints(edge_[i].divided) + x * Ints(edge_[i].test_x) + y * Ints(edge_[i].test_y);
    }
    const Truth lines_there = line <= Ints(last);
    const Ints size(tile_.size - 1);
    for (int step = 0; step < static_cast<int>(steps_) + 1; ++step) {
      const Ints outside = e[0] | e[1] | e[2] | across | (size - across);
      const std::uint32_t hit = bits(outside >= Ints(0) && lines_there);
      if (hit != 0) write(hit, x, y);
      across = across + Ints(1);
      for (std::size_t i = 0; i < 3; ++i) {
        e[i] = e[i] + Ints(steep_ ? edge_[i].test_x : edge_[i].test_y);
      }
    }
  }

  void write(std::uint32_t hit, Ints x, Ints y) {
    const auto exact = [&](const TileEdge& e) {
      return to_number(Doubles(static_cast<double>(e.exact)) +
                       Doubles(256) *
                           (to_doubles(x) * Doubles(e.step_x) + to_doubles(y) * Doubles(e.step_y)));
    };
    const Number depth =
        Number(triangle_.depth[0]) + (exact(edge_[1]) * k1_ + exact(edge_[2]) * k2_);
    const Ints pixel =
        (x + shift_right<3>(x) * Ints(56)) +
        (shift_left<3>(y) + shift_right<3>(y) * Ints(64 * tile_.blocks_per_row() - 64));
    std::array<std::uint32_t, lanes> key;
    key.fill(triangle_.key);
    writer_.write(hit, pixel, depth, key.data());
  }

  const Tile& tile_;
  const LargeTriangle& triangle_;
  HitWriter& writer_;
  std::array<TileEdge, 3> edge_;
  bool steep_ = false;
  float slope_ = 0;
  float base_ = 0;
  float start_ = 0;
  float steps_ = 0;
  Number k1_;
  Number k2_;
};

// ---------------------------------------------------------------------------------------------
// A tile

void update_far(const Tile& tile, BlockMask blocks) {
  for (; blocks != 0; blocks &= blocks - 1) {
    const int block = std::countr_zero(blocks);
    Number far = load(tile.depth + block * 64);
    for (int g = 1; g < groups; ++g) {
      far = minimum(far, load(tile.depth + block * 64 + g * lanes));
    }
    tile.block_far[block] = smallest(far);
  }
}

}  // namespace

void draw_tile(const DrawJob& job, int index, std::span<Worker> workers, Worker& worker) {
  const Tile tile = job.frame.tile(index);
  HitWriter writer(tile);
  for (const Worker& from : workers) {
    for (const auto* chunk = from.bins[static_cast<std::size_t>(index)].large.first;
         chunk != nullptr; chunk = chunk->next) {
      for (int i = 0; i < chunk->count; ++i) {
        const LargeTriangle& triangle = *chunk->triangle[static_cast<std::size_t>(i)];
        if (!job.discards() && ThinDrawing(tile, triangle, writer).draw()) continue;
        LargeDrawing drawing(job, tile, triangle);
        if (!drawing.misses()) drawing.draw(worker);
      }
    }
  }
  update_far(tile, writer.take_written_blocks());
  for (const Worker& from : workers) {
    for (const auto* chunk = from.bins[static_cast<std::size_t>(index)].small.first;
         chunk != nullptr; chunk = chunk->next) {
      draw_small(tile, *chunk, job.skip.hidden, writer);
      update_far(tile, writer.take_written_blocks());
    }
  }
  job.frame.tile_far(index) =
      *std::min_element(tile.block_far, tile.block_far + tile.block_count());
}

}  // namespace rasterlab::RASTERLAB_SIMD

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
      write_one(pixel_of[lane], depth_of[lane], key[lane]);
    }
  }

  /// Blocks written to since the last call.
  BlockMask take_written_blocks() { return std::exchange(written_, 0); }

 private:
  /// Without a branch: which of two is nearer, a processor can't guess.
  void write_one(std::int32_t pixel, float depth, std::uint32_t key) {
    float& depth_there = tile_.depth[pixel];
    std::uint32_t& key_there = tile_.key[pixel];
    const bool nearer =
        static_cast<int>(depth > depth_there) |
        (static_cast<int>(depth == depth_there) & static_cast<int>(key < key_there));
    const std::uint32_t mask = 0U - static_cast<std::uint32_t>(nearer);
    const auto choose = [mask](std::uint32_t a, std::uint32_t b) { return b ^ ((a ^ b) & mask); };
    depth_there = std::bit_cast<float>(
        choose(std::bit_cast<std::uint32_t>(depth), std::bit_cast<std::uint32_t>(depth_there)));
    key_there = choose(key, key_there);
    written_ |= BlockMask{1} << (pixel >> 6);
  }

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

  std::int64_t at(int x, int y) const {
    return exact +
           256 * (static_cast<std::int64_t>(step_x) * x + static_cast<std::int64_t>(step_y) * y);
  }
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

/// Blocks of the tile that the box around a triangle's samples reaches into.
BlockMask blocks_in_bounds(const Tile& tile, const LargeTriangle& t) {
  const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const int last = tile.size - 1;
  const int left = std::clamp(((low_x + 127) >> 8) - tile.left, 0, last) / 8;
  const int right = std::clamp(((high_x - 128) >> 8) - tile.left, 0, last) / 8;
  const int top = std::clamp(((low_y + 127) >> 8) - tile.top, 0, last) / 8;
  const int bottom = std::clamp(((high_y - 128) >> 8) - tile.top, 0, last) / 8;
  const auto ones = [](int count) { return ~BlockMask{0} >> (64 - count); };
  const int per_row = tile.blocks_per_row();
  const BlockMask first_of_rows = ones(tile.block_count()) / ones(per_row);
  const BlockMask columns = (ones(right - left + 1) << left) * first_of_rows;
  return columns & ones((bottom - top + 1) * per_row) << (top * per_row);
}

/// Blocks whose every pixel is nearer than `nearest`.
BlockMask blocks_before(const Tile& tile, float nearest) {
  BlockMask before = 0;
  for (int first = 0; first < tile.block_count(); first += lanes) {
    const Truth far = load(tile.block_far + first) > Number(nearest);
    before |= static_cast<BlockMask>(bits(far)) << first;
  }
  return before;
}

/// Blocks in which a triangle may be seen.
BlockMask open_blocks(const DrawJob& job, const Tile& tile, const LargeTriangle& triangle,
                      Statistics& statistics) {
  const BlockMask near = blocks_in_bounds(tile, triangle);
  if (!job.skip.hidden) return near;
  const float nearest =
      std::max({triangle.depth[0], triangle.depth[1], triangle.depth[2]}) * 1.000001F;
  const BlockMask hidden = near & blocks_before(tile, nearest);
  statistics.blocks_hidden += static_cast<unsigned>(std::popcount(hidden));
  return near & ~hidden;
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
      const std::int64_t e1 = edge_[1].at(x + gx, y + gy);
      const std::int64_t e2 = edge_[2].at(x + gx, y + gy);
      if (slopes_.is_short) {
        return slopes_.depth(as_numbers(Ints(static_cast<std::int32_t>(e1)) + short1_),
                             as_numbers(Ints(static_cast<std::int32_t>(e2)) + short2_));
      }
      return slopes_.depth(to_number(Doubles(static_cast<double>(e1)) + offset1_),
                           to_number(Doubles(static_cast<double>(e2)) + offset2_));
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
    slopes_ = DepthSlopes(triangle_, edge_[0]);
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
    std::array<Ints, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
      const Ints step_along(steep_ ? edge_[i].test_y : edge_[i].test_x);
      const Ints step_across(steep_ ? edge_[i].test_x : edge_[i].test_y);
      e[i] = Ints(edge_[i].divided) + line * step_along + across * step_across;
    }
    const Truth lines_there = line <= Ints(last);
    const Ints size(tile_.size - 1);
    // Most lines have a sample or none: what they have is gathered and written together.
    std::uint32_t found = 0;
    Ints sample = across;
    for (int step = 0; step < static_cast<int>(steps_) + 1; ++step) {
      const Ints outside = e[0] | e[1] | e[2] | across | (size - across);
      const Truth hit = outside >= Ints(0) && lines_there;
      const std::uint32_t hit_bits = bits(hit);
      if ((hit_bits & found) != 0) {
        write(found, line, sample);
        found = 0;
      }
      found |= hit_bits;
      sample = select(hit, across, sample);
      across = across + Ints(1);
      for (std::size_t i = 0; i < 3; ++i) {
        e[i] = e[i] + Ints(steep_ ? edge_[i].test_x : edge_[i].test_y);
      }
    }
    if (found != 0) write(found, line, sample);
  }

  Number edge_at(const TileEdge& edge, Ints x, Ints y) const {
    if (slopes_.is_short) {
      return as_numbers(Ints(static_cast<std::int32_t>(edge.exact)) +
                        shift_left<8>(x * Ints(edge.step_x) + y * Ints(edge.step_y)));
    }
    return to_number(Doubles(static_cast<double>(edge.exact)) +
                     Doubles(256) * (to_doubles(x) * Doubles(edge.step_x) +
                                     to_doubles(y) * Doubles(edge.step_y)));
  }

  void write(std::uint32_t hit, Ints line, Ints across) {
    const Ints x = steep_ ? across : line;
    const Ints y = steep_ ? line : across;
    const Number depth = slopes_.depth(edge_at(edge_[1], x, y), edge_at(edge_[2], x, y));
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
  DepthSlopes slopes_;
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
        const BlockMask open = open_blocks(job, tile, triangle, worker.statistics);
        if (open == 0) continue;
        if (!job.discards() && ThinDrawing(tile, triangle, writer).draw()) continue;
        LargeDrawing drawing(job, tile, triangle, open);
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

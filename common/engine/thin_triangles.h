// Slivers, one per lane: all lanes walk along their own one at once, line by line.
//
// A sliver has a sample or two on each line it crosses: rows, when it is steep, columns, when it is
// flat. They lie between its longest side and a parallel through its third corner: where that strip
// crosses a line is known beforehand to a small part of a pixel, and how many pixels to ask there
// is the same on all lines. The exact edge functions have the last word.
//
// Few lanes hit at a time. So a hit is only noted on the way, and later as many are worked out at
// once as there are lanes.
#pragma once

#include "common/engine/hit_list.h"
#include "common/engine/pixel_words.h"
#include "common/engine/thin_in_tile.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

/// What slivers' lines are asked with.
struct LinesOfThin {
  Ints first, last;  ///< lines of the tile, as far as the sliver reaches; none: last < first
  Ints low, high;    ///< pixels across
  Ints strip;        ///< where the strip begins on the first line, in 2^-18 pixels …
  Ints strip_step;   ///< … and how much farther on the next
  int pixels;        ///< to ask on each line
};

/// `lines`: those to walk along; `pixels`: how many the tile has across. Lanes that aren't
/// `present` have no lines.
inline LinesOfThin find_lines(const ThinCorners& t, const LaneLines& lines, Ints pixels,
                              Truth present) {
  std::array<Ints, 3> along = t.along;
  std::array<Ints, 3> across = t.across;
  LinesOfThin result;
  result.first = lines.first;
  result.last = select(present, lines.last, lines.first - Ints(1));
  result.low = maximum(shift_right<8>(smallest_of(across) + Ints(127)), Ints(0));
  result.high = minimum(shift_right<8>(largest_of(across) - Ints(128)), pixels - Ints(1));
  sort_corners(along, across);
  // The longest side goes from the first to the last corner. Its slope is at most 1 and it is at
  // most 2^15.5 units wide, so that float knows it to a hundredth of a unit.
  const Number slope = as_numbers(across[2] - across[0]) / as_numbers(along[2] - along[0]);
  const Number third = as_numbers(across[1] - across[0]) - slope * as_numbers(along[1] - along[0]);
  const Ints first_center = shift_left<8>(result.first) + Ints(128);
  const Number on_first = slope * as_numbers(first_center - along[0]);
  // One unit to spare on either side, and from a pixel's centre to its first unit's.
  const Number begin = on_first + minimum(third, Number(0)) - Number(1 + 128);
  // 2^10 to the unit; rounding up to the first pixel takes a pixel less a trifle.
  result.strip = shift_left<10>(across[0]) + to_whole(begin * Number(1024)) + Ints((1 << 18) - 1);
  result.strip_step = to_whole(slope * Number(256 * 1024));
  const Number width = magnitude(third) * Number(1.0F / 256) + Number(1.0F / 64);
  result.pixels = static_cast<int>(largest(select(present, width, Number(0)))) + 1;
  return result;
}

/// An edge function by lines and pixels across them.
struct EdgeOfThin {
  Ints value;     ///< on the lane's first line, at pixel 0, lessened as LaneEdge's
  Ints along;     ///< its step to the next line …
  Ints across;    ///< … and to the next pixel
  Ints on_line0;  ///< not lessened, on the tile's first line
};

/// What a hit's depth is worked out from, per sliver.
struct ThinTable {
  using Values = std::array<float, 16>;

  struct Edge {
    alignas(64) Values value, along, across;  ///< of EdgeOfThin, the value on the tile's first line
  };
  std::array<Edge, 2> edge;  ///< 1 and 2
  alignas(64) Values d0, k1, k2;
  alignas(64) Values key;
  alignas(64) Values steep;  ///< all bits or none
};

/// Hits of as many slivers as there are lanes: gathered first, then worked out, then written.
class ThinHits {
 public:
  explicit ThinHits(const Tile& tile) : tile_(tile) {}

  ThinTable table;

  static Ints number_of(Ints lane, Ints line, Ints pixel) {
    return shift_left<12>(lane) + (shift_left<6>(line) + pixel);
  }

  bool is_full() const { return count_ > capacity; }
  void add(Truth hit, Ints number) {
    store_packed(hit, number, number_.data() + count_);
    count_ += std::popcount(bits(hit));
  }

  /// Calls `write(place in the tile, word)` for each.
  template <class Write>
  void write_all(const Write& write) {
    store(Ints(0), number_.data() + count_);
    for (int i = 0; i < count_; i += lanes) work_out(i);
    for (int i = 0; i < count_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      write(number_[at], word_[at]);
    }
    count_ = 0;
  }

 private:
  static constexpr int capacity = 512;
  static constexpr std::size_t room = capacity + 2 * lanes;

  /// Places in place of numbers, and words.
  void work_out(int first) {
    const Ints number = load(number_.data() + first);
    const Ints lane = shift_right<12>(number) & Ints(lanes - 1);
    const Ints line = shift_right<6>(number) & Ints(63);
    const Ints pixel = number & Ints(63);
    const auto own = [&](const ThinTable::Values& values) { return look_up(values, lane); };
    const auto edge = [&](const ThinTable::Edge& e) {
      return as_numbers(bit_pattern(own(e.value)) +
                        (line * bit_pattern(own(e.along)) + pixel * bit_pattern(own(e.across))));
    };
    const Number depth =
        own(table.d0) + (edge(table.edge[0]) * own(table.k1) + edge(table.edge[1]) * own(table.k2));
    const Truth steep = bit_pattern(own(table.steep)) < Ints(0);
    store_pixel_words(depth, bit_pattern(own(table.key)), word_.data() + first);
    store(place_in_tile(tile_, select(steep, pixel, line), select(steep, line, pixel)),
          number_.data() + first);
  }

  const Tile& tile_;
  int count_ = 0;
  alignas(64) std::array<std::int32_t, room> number_;
  alignas(64) std::array<std::int64_t, room> word_;
};

/// Slivers of a tile, ready to be walked along.
struct ThinLanes {
  LinesOfThin lines;
  std::array<EdgeOfThin, 3> edge;

  ThinLanes(const ThinCorners& t, const LaneLines& where, const Tile& tile, Truth present)
      : lines(find_lines(t, where, select(t.steep, Ints(tile.width), Ints(tile.height)), present)) {
    const Ints first_center = shift_left<8>(lines.first) + Ints(128);
    const Ints px = select(t.steep, Ints(128), first_center);
    const Ints py = select(t.steep, first_center, Ints(128));
    for (std::size_t i = 0; i < 3; ++i) {
      const LaneEdge e(t.corners, i, px, py);
      const Ints along = select(t.steep, e.step_y, e.step_x);
      const Ints across = select(t.steep, e.step_x, e.step_y);
      edge[i] = {e.value, along, across, e.value + e.lessened - lines.first * along};
    }
  }

  void fill(const ThinCorners& t, ThinTable& table) const {
    const auto put = [](Ints values, ThinTable::Values& to) {
      store(from_bit_pattern(values), to.data());
    };
    for (std::size_t i = 0; i < 2; ++i) {
      put(edge[i + 1].on_line0, table.edge[i].value);
      put(edge[i + 1].along, table.edge[i].along);
      put(edge[i + 1].across, table.edge[i].across);
    }
    const LaneDepth depth(t.corners, t.depth);
    store(depth.d0, table.d0.data());
    store(depth.k1, table.k1.data());
    store(depth.k2, table.k2.data());
    put(t.key, table.key);
    put(select(t.steep, Ints(-1), Ints(0)), table.steep);
  }
};

template <class Write>
void walk_thin(ThinLanes& t, ThinHits& hits, const Write& write) {
  const Ints steps = t.lines.last - t.lines.first;
  const std::int32_t most = largest(steps);
  Ints number = ThinHits::number_of(iota(0), t.lines.first, Ints(0));
  for (std::int32_t step = 0; step <= most; ++step) {
    Ints pixel = shift_right<18>(t.lines.strip);
    std::array<Ints, 3> e;
    for (std::size_t i = 0; i < 3; ++i) e[i] = t.edge[i].value + pixel * t.edge[i].across;
    for (int more = t.lines.pixels; more > 0; --more) {
      // Negative: outside an edge, or beyond the lane's own pixels.
      const Ints outside = (e[0] | e[1] | e[2]) | ((pixel - t.lines.low) | (t.lines.high - pixel)) |
                           (steps - Ints(step));
      hits.add(outside >= Ints(0), number + pixel);
      pixel = pixel + Ints(1);
      for (std::size_t i = 0; i < 3; ++i) e[i] = e[i] + t.edge[i].across;
    }
    if (hits.is_full()) hits.write_all(write);
    number = number + Ints(64);
    t.lines.strip = t.lines.strip + t.lines.strip_step;
    for (EdgeOfThin& edge : t.edge) edge.value = edge.value + edge.along;
  }
  hits.write_all(write);
}

/// Calls `write(place in the tile, word)` (pixel_words.h) for each sample.
template <class Write>
void draw_thin(const Tile& tile, std::span<const ThinInTile> slivers, const Write& write) {
  ThinHits hits(tile);
  for (std::size_t from = 0; from < slivers.size(); from += lanes) {
    const std::size_t count = std::min<std::size_t>(lanes, slivers.size() - from);
    std::array<const LargeTriangle*, lanes> triangle;
    std::array<std::int32_t, lanes> first;
    std::array<std::int32_t, lanes> last;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const ThinInTile& thin = slivers[from + std::min(lane, count - 1)];
      triangle[lane] = thin.triangle;
      first[lane] = thin.first;
      last[lane] = thin.last;
    }
    const ThinCorners corners =
        load_corners([&](std::size_t lane) { return triangle[lane]; }, tile);
    ThinLanes t(corners, {load(first.data()), load(last.data())}, tile,
                first_lanes(static_cast<int>(count)));
    t.fill(corners, hits.table);
    walk_thin(t, hits, write);
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD

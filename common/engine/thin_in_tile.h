// Which lines of a tile its slivers may have samples on; slivers sorted by how many these are.
//
// Lines are rows for a steep sliver, columns for a flat one: across the axis it reaches farthest
// on, its major one.
#pragma once

#include "common/engine/lane_triangles.h"

#include <algorithm>
#include <numeric>

namespace rasterlab::RASTERLAB_SIMD {

/// Slivers, one per lane. Coordinates count from the tile's corner.
struct ThinCorners {
  LaneCorners corners;
  std::array<Number, 3> depth;
  Ints key;
  Ints width;
  Truth steep;
  std::array<Ints, 3> along, across;  ///< the major axis
};

/// `triangle(lane)` points to a lane's.
template <class Triangle>
ThinCorners load_corners(const Triangle& triangle, const Tile& tile) {
  std::array<Number, 12> words;
  static_assert(sizeof(LargeTriangle) == words.size() * sizeof(float));
  for (std::size_t i = 0; i < words.size(); i += 4) {
    const auto place = [&](std::size_t lane) {
      return reinterpret_cast<const float*>(triangle(lane)) + i;
    };
    load_fours(place, words.data() + i);
  }
  ThinCorners t;
  for (std::size_t i = 0; i < 3; ++i) {
    t.corners.x[i] = bit_pattern(words[i]) - Ints(tile.left * 256);
    t.corners.y[i] = bit_pattern(words[3 + i]) - Ints(tile.top * 256);
    t.depth[i] = words[6 + i];
  }
  t.key = bit_pattern(words[9]);
  t.width = bit_pattern(words[10]);
  const auto reach = [](const std::array<Ints, 3>& a) { return largest_of(a) - smallest_of(a); };
  t.steep = reach(t.corners.y) > reach(t.corners.x);
  for (std::size_t i = 0; i < 3; ++i) {
    t.along[i] = select(t.steep, t.corners.y[i], t.corners.x[i]);
    t.across[i] = select(t.steep, t.corners.x[i], t.corners.y[i]);
  }
  return t;
}

/// Sorts three corners by a.
inline void sort_corners(std::array<Ints, 3>& a, std::array<Ints, 3>& b) {
  const auto order = [&](std::size_t i, std::size_t j) {
    const Truth swap = a[i] > a[j];
    const Ints a_i = select(swap, a[j], a[i]);
    const Ints b_i = select(swap, b[j], b[i]);
    a[j] = select(swap, a[i], a[j]);
    b[j] = select(swap, b[i], b[j]);
    a[i] = a_i;
    b[i] = b_i;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

/// Lines first ≤ line ≤ last.
struct LaneLines {
  Ints first, last;
};

/// Where the longest side, of corners 0 and 2, is not farther beside the tile than the sliver is
/// wide, and a trifle.
inline LaneLines lines_not_beside(const std::array<Ints, 3>& along,
                                  const std::array<Ints, 3>& across, Ints width, Ints pixels) {
  const Number rise = as_numbers(across[2] - across[0]);
  const Truth level = magnitude(rise) <= Number(256);
  const Number per_unit = as_numbers(along[2] - along[0]) / select(level, Number(1), rise);
  const Number start = as_numbers(across[0]);
  const Number margin = Number(256) * (as_numbers(width) + Number(1.25F));
  const Number before = (Number(0) - margin - start) * per_unit;
  const Number after = (Number(256) * as_numbers(pixels) + margin - start) * per_unit;
  const auto line_at = [&](Number way) {
    const Number line = (as_numbers(along[0]) + way) * Number(1.0F / 256);
    return to_whole(minimum(maximum(line, Number(-1)), Number(65)));
  };
  return {select(level, Ints(0), line_at(minimum(before, after)) - Ints(1)),
          select(level, Ints(64), line_at(maximum(before, after)) + Ints(1))};
}

/// Those that slivers reach, but not where they are beside the tile.
inline LaneLines lines_in_tile(const ThinCorners& t, const Tile& tile) {
  std::array<Ints, 3> along = t.along;
  std::array<Ints, 3> across = t.across;
  sort_corners(along, across);
  const Ints lines = select(t.steep, Ints(tile.height), Ints(tile.width));
  const Ints pixels = select(t.steep, Ints(tile.width), Ints(tile.height));
  const LaneLines near = lines_not_beside(along, across, t.width, pixels);
  return {maximum(maximum(shift_right<8>(along[0] + Ints(127)), Ints(0)), near.first),
          minimum(minimum(shift_right<8>(along[2] - Ints(128)), lines - Ints(1)), near.last)};
}

static_assert(ThinList::capacity % lanes == 0);

inline void find_in_tile(const ThinList& slivers, const Tile& tile,
                         std::vector<ThinInTile>& found) {
  for (int from = 0; from < slivers.count; from += lanes) {
    // There is always a whole vector of them, be it of anything.
    const LargeTriangle* triangle = &slivers.triangle[static_cast<std::size_t>(from)];
    const ThinCorners corners =
        load_corners([triangle](std::size_t lane) { return triangle + lane; }, tile);
    const LaneLines lines = lines_in_tile(corners, tile);
    const Truth present = first_lanes(std::min(slivers.count - from, lanes));
    std::array<std::int32_t, lanes> first;
    std::array<std::int32_t, lanes> last;
    store(lines.first, first.data());
    store(lines.last, last.data());
    std::uint32_t reached = bits(present && lines.first <= lines.last);
    for (; reached != 0; reached &= reached - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(reached));
      const int likeness = triangle[lane].thin_width * 64 + (last[lane] - first[lane]);
      found.push_back({triangle + lane, static_cast<std::uint8_t>(first[lane]),
                       static_cast<std::uint8_t>(last[lane]),
                       static_cast<std::uint16_t>(likeness)});
    }
  }
}

/// By how wide they are and how many lines they have in the tile: so that as many as there are
/// lanes, walking along side by side, end at the same time.
inline void sort_thin(const std::vector<ThinInTile>& found, std::vector<ThinInTile>& sorted) {
  std::array<std::uint32_t, (ThinList::max_width + 1)* 64 + 1> place = {};
  for (const ThinInTile& thin : found) ++place[thin.likeness + std::size_t{1}];
  std::partial_sum(place.begin(), place.end(), place.begin());
  sorted.resize(found.size());
  for (const ThinInTile& thin : found) sorted[place[thin.likeness]++] = thin;
}

}  // namespace rasterlab::RASTERLAB_SIMD

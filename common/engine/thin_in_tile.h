// Which lines of a tile its slivers may have samples on; slivers sorted by how many these are.
//
// Lines are rows for a steep sliver, columns for a flat one: across the axis it reaches farthest
// on, its major one.
#pragma once

#include "common/engine/lane_triangles.h"

#include <algorithm>
#include <numeric>
#include <span>

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
  static_assert(sizeof(LargeTriangle) >= words.size() * sizeof(float));
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

/// Likenesses are below this one, that of slivers that have no lines in the tile.
inline constexpr int without_lines = (LargeTriangle::max_thin_width + 1) * 64;

/// Finds the lines of as many slivers as there are lanes, or fewer.
inline void find_lines_of_some(std::span<ThinInTile> slivers, const Tile& tile) {
  const auto last_sliver = slivers.size() - 1;
  const ThinCorners corners = load_corners(
      [&](std::size_t lane) { return slivers[std::min(lane, last_sliver)].triangle; }, tile);
  const LaneLines lines = lines_in_tile(corners, tile);
  const Ints steps = lines.last - lines.first;
  std::array<std::int32_t, lanes> first;
  std::array<std::int32_t, lanes> last;
  std::array<std::int32_t, lanes> likeness;
  store(lines.first, first.data());
  store(lines.last, last.data());
  store(select(steps < Ints(0), Ints(without_lines), shift_left<6>(corners.width) + steps),
        likeness.data());
  for (std::size_t lane = 0; lane < slivers.size(); ++lane) {
    slivers[lane].first = static_cast<std::uint8_t>(first[lane]);
    slivers[lane].last = static_cast<std::uint8_t>(last[lane]);
    slivers[lane].likeness = static_cast<std::uint16_t>(likeness[lane]);
  }
}

/// Those that have lines, sorted by how wide they are and by how many lines they have: so that as
/// many as there are lanes, walking along side by side, end at the same time.
inline void sort_thin(std::span<const ThinInTile> slivers, std::vector<ThinInTile>& sorted) {
  std::array<std::uint32_t, without_lines + 2> place = {};
  for (const ThinInTile& thin : slivers) ++place[thin.likeness + std::size_t{1}];
  std::partial_sum(place.begin(), place.end(), place.begin());
  const std::uint32_t count = place[without_lines];
  sorted.resize(slivers.size());
  for (const ThinInTile& thin : slivers) sorted[place[thin.likeness]++] = thin;
  sorted.resize(count);
}

/// `slivers`: of a tile's bins.
inline void find_in_tile(std::span<ThinInTile> slivers, const Tile& tile,
                         std::vector<ThinInTile>& sorted) {
  for (std::size_t from = 0; from < slivers.size(); from += lanes) {
    find_lines_of_some(slivers.subspan(from, std::min<std::size_t>(lanes, slivers.size() - from)),
                       tile);
  }
  sort_thin(slivers, sorted);
}

}  // namespace rasterlab::RASTERLAB_SIMD

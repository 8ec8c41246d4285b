// Slivers, one per lane: all lanes walk along their own one at once, line by line. So that they end
// at the same time, slivers of a tile are sorted first by how many lines they have there.
//
// A sliver has a sample or two on each line it crosses: rows, when it is steep, columns, when it is
// flat. They lie between its longest side and a parallel through its third corner: where that strip
// crosses a line is known beforehand to a small part of a pixel, and how many pixels to ask there
// is the same on all lines. The exact edge functions have the last word.
#pragma once

#include "common/engine/hit_list.h"
#include "common/engine/lane_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rasterlab::RASTERLAB_SIMD {

/// Along the axis a sliver reaches farthest on (its major one), and across.
struct LinesOfThin {
  Ints first, last;  ///< lines of the tile, as far as the sliver reaches; none: last < first
  Ints low, high;    ///< pixels across
  Ints strip;        ///< where the strip begins on the first line, in 2^-18 pixels …
  Ints strip_step;   ///< … and how much farther on the next
  int pixels;        ///< to ask on each line
};

struct ThinLanes {
  Truth steep;
  LinesOfThin lines;
  std::array<LaneEdge, 3> edge;       ///< on the lane's first line, at pixel 0
  std::array<Ints, 3> along, across;  ///< their steps to the next line, and to the next pixel
  LaneDepth depth;
};

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

/// `along` and `across`: the corners' coordinates; `pixels`: how many the tile has across. Lanes
/// that aren't `present` have no lines.
inline LinesOfThin find_lines(std::array<Ints, 3> along, std::array<Ints, 3> across, Ints first,
                              Ints last, Ints pixels, Truth present) {
  LinesOfThin result;
  result.first = first;
  result.last = select(present, last, first - Ints(1));
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

inline ThinLanes load_thin(const ThinTriangles& triangles, int from, const Tile& tile) {
  const Truth present = first_lanes(std::min(triangles.count - from, lanes));
  LaneCorners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners.x[i] = load(triangles.x[i].data() + from);
    corners.y[i] = load(triangles.y[i].data() + from);
  }
  const auto reach = [](const std::array<Ints, 3>& a) { return largest_of(a) - smallest_of(a); };
  const Truth steep = reach(corners.y) > reach(corners.x);
  std::array<Ints, 3> along;
  std::array<Ints, 3> across;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = select(steep, corners.y[i], corners.x[i]);
    across[i] = select(steep, corners.x[i], corners.y[i]);
  }
  const LinesOfThin lines = find_lines(along, across, load(triangles.first.data() + from),
                                       load(triangles.last.data() + from),
                                       select(steep, Ints(tile.width), Ints(tile.height)), present);
  const Ints first_center = shift_left<8>(lines.first) + Ints(128);
  const Ints px = select(steep, Ints(128), first_center);
  const Ints py = select(steep, first_center, Ints(128));
  ThinLanes t = {
      steep,
      lines,
      {LaneEdge(corners, 0, px, py), LaneEdge(corners, 1, px, py), LaneEdge(corners, 2, px, py)},
      {},
      {},
      LaneDepth(corners, triangles.depth[0].data() + from, triangles.depth[1].data() + from,
                triangles.depth[2].data() + from)};
  for (std::size_t i = 0; i < 3; ++i) {
    t.along[i] = select(steep, t.edge[i].step_y, t.edge[i].step_x);
    t.across[i] = select(steep, t.edge[i].step_x, t.edge[i].step_y);
  }
  return t;
}

inline void walk_thin(const Tile& tile, ThinLanes t, Ints key, HitList& hits) {
  const Ints steps = t.lines.last - t.lines.first;
  const std::int32_t most = largest(steps);
  Ints line = t.lines.first;
  for (std::int32_t step = 0; step <= most; ++step) {
    Ints pixel = shift_right<18>(t.lines.strip);
    std::array<Ints, 3> e;
    for (std::size_t i = 0; i < 3; ++i) e[i] = t.edge[i].value + pixel * t.across[i];
    for (int more = t.lines.pixels; more > 0; --more) {
      // Negative: outside an edge, or beyond the lane's own pixels.
      const Ints outside = (e[0] | e[1] | e[2]) | ((pixel - t.lines.low) | (t.lines.high - pixel)) |
                           (steps - Ints(step));
      const Truth hit = outside >= Ints(0);
      if (any(hit)) {
        const Ints x = select(t.steep, pixel, line);
        const Ints y = select(t.steep, line, pixel);
        hits.add(hit, place_in_tile(tile, x, y),
                 t.depth.at(e[1] + t.edge[1].lessened, e[2] + t.edge[2].lessened), key);
      }
      pixel = pixel + Ints(1);
      for (std::size_t i = 0; i < 3; ++i) e[i] = e[i] + t.across[i];
    }
    line = line + Ints(1);
    t.lines.strip = t.lines.strip + t.lines.strip_step;
    for (std::size_t i = 0; i < 3; ++i) t.edge[i].value = t.edge[i].value + t.along[i];
  }
}

/// A sliver's box in one tile, along its lines and across them, from the tile's corner.
struct ThinBox {
  std::array<int, 3> along, across;  ///< the corners, 1/256 pixel
  int lines, pixels;                 ///< how many the tile has
};

inline ThinBox box_in_tile(const LargeTriangle& triangle, const Tile& tile) {
  const auto [left, right] = std::minmax({triangle.x[0], triangle.x[1], triangle.x[2]});
  const auto [top, bottom] = std::minmax({triangle.y[0], triangle.y[1], triangle.y[2]});
  const bool steep = bottom - top > right - left;
  ThinBox box = {triangle.x, triangle.y, tile.width, tile.height};
  for (int& x : box.along) x -= tile.left * 256;
  for (int& y : box.across) y -= tile.top * 256;
  if (steep) {
    std::swap(box.along, box.across);
    std::swap(box.lines, box.pixels);
  }
  return box;
}

/// Lines first ≤ line ≤ last.
struct LineRange {
  int first, last;
};

/// Where the longest side, from corner `start` to corner `end`, is not farther beside the tile than
/// the sliver is wide, and a trifle.
inline LineRange lines_not_beside(const ThinBox& box, std::size_t start, std::size_t end,
                                  int whole_width) {
  const auto from = static_cast<float>(box.across[start]);
  const float rise = static_cast<float>(box.across[end]) - from;
  if (std::abs(rise) <= 256) return {0, box.lines - 1};
  const float margin = 256.0F * (static_cast<float>(whole_width) + 1.25F);
  const float per_unit = static_cast<float>(box.along[end] - box.along[start]) / rise;
  const float before = (-margin - from) * per_unit;
  const float after = (256.0F * static_cast<float>(box.pixels) + margin - from) * per_unit;
  const auto line_at = [&](float way) {
    return static_cast<int>(
        std::clamp((static_cast<float>(box.along[start]) + way) * (1.0F / 256), -1.0F, 65.0F));
  };
  return {line_at(std::min(before, after)) - 1, line_at(std::max(before, after)) + 1};
}

/// The lines of a tile that a sliver may have samples on: those it reaches, but not where it is
/// beside the tile.
inline ThinInTile in_tile(const LargeTriangle& triangle, const Tile& tile) {
  const ThinBox box = box_in_tile(triangle, tile);
  const auto start = std::min_element(box.along.begin(), box.along.end());
  const auto end = std::max_element(box.along.begin(), box.along.end());
  const auto number = [&](auto corner) {
    return static_cast<std::size_t>(corner - box.along.begin());
  };
  const LineRange near = lines_not_beside(box, number(start), number(end), triangle.thin_width);
  const int first = std::max({(*start + 127) >> 8, 0, near.first});
  const int last = std::min({(*end - 128) >> 8, box.lines - 1, near.last});
  const auto likeness = static_cast<std::uint32_t>(triangle.thin_width * 64 + (last - first));
  return {&triangle, first, last, likeness};
}

/// Sorted by how wide they are and how many lines they have in the tile.
inline void sort_thin(const Tile& tile, const std::vector<ThinInTile>& found,
                      ThinTriangles& sorted) {
  std::array<std::uint32_t, ThinTriangles::max_width* 64 + 1> place = {};
  for (const ThinInTile& thin : found) ++place[thin.likeness + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  sorted.resize(found.size());
  for (const ThinInTile& thin : found) {
    const std::size_t to = place[thin.likeness]++;
    for (std::size_t i = 0; i < 3; ++i) {
      sorted.x[i][to] = thin.triangle->x[i] - tile.left * 256;
      sorted.y[i][to] = thin.triangle->y[i] - tile.top * 256;
      sorted.depth[i][to] = thin.triangle->depth[i];
    }
    sorted.key[to] = thin.triangle->key;
    sorted.first[to] = thin.first;
    sorted.last[to] = thin.last;
  }
}

inline void draw_thin(const Tile& tile, const ThinTriangles& triangles, HitList& hits) {
  for (int from = 0; from < triangles.count; from += lanes) {
    walk_thin(tile, load_thin(triangles, from, tile), load(triangles.key.data() + from), hits);
  }
  hits.write();
}

}  // namespace rasterlab::RASTERLAB_SIMD

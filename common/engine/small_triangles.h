// Triangles of at most 4×4 samples, one per lane: all lanes walk over their own pixels at once.
#pragma once

#include "common/engine/hit_list.h"
#include "common/engine/lane_triangles.h"

namespace rasterlab::RASTERLAB_SIMD {

/// Ready to be walked over.
struct SmallLanes {
  Ints left, top;             ///< the first pixel of the tile
  Ints columns, rows;         ///< pixels to walk over, less one; −1 in lanes without a triangle
  std::array<LaneEdge, 3> e;  ///< at the first pixel
  LaneDepth depth;
  Ints key;
};

/// Which lanes' triangles are behind all that the blocks they touch already show: those of their
/// bounds' corners, no others.
inline Truth hidden_lanes(const Tile& tile, const LaneBounds& bounds, Number nearest) {
  const Ints per_row(tile.blocks_per_row());
  const Ints last(tile.blocks_per_row() - 1);
  const auto block = [&](Ints pixel) {
    return minimum(maximum(shift_right<3>(pixel), Ints(0)), last);
  };
  const auto farther = [&](Ints row) {
    const auto far = [&](Ints x) {
      return gather_numbers(tile.block_far, block(row) * per_row + block(x));
    };
    return minimum(far(bounds.left), far(bounds.right));
  };
  return minimum(farther(bounds.top), farther(bounds.bottom)) > nearest;
}

inline SmallLanes load_small(const PackedTriangles& triangles, int from, const Tile& tile,
                             bool skip_hidden) {
  const LaneTriangles t(triangles, from);
  const LaneCorners& corners = t.corners;
  const LaneBounds bounds(corners, tile.width, tile.height);
  const Ints px = shift_left<8>(bounds.left) + Ints(128);
  const Ints py = shift_left<8>(bounds.top) + Ints(128);
  const LaneDepth depth(corners, t.depth);
  Truth present = first_lanes(std::min(triangles.count - from, lanes));
  if (skip_hidden) present = present && !hidden_lanes(tile, bounds, depth.bounds.near);
  return {
      bounds.left,
      bounds.top,
      select(present, bounds.right - bounds.left, Ints(-1)),
      select(present, bounds.bottom - bounds.top, Ints(-1)),
      {LaneEdge(corners, 0, px, py), LaneEdge(corners, 1, px, py), LaneEdge(corners, 2, px, py)},
      depth,
      t.key};
}

inline void walk_small(const Tile& tile, SmallLanes t, HitList& hits) {
  const std::int32_t columns = largest(t.columns);
  const std::int32_t rows = largest(t.rows);
  for (std::int32_t row = 0; row <= rows; ++row) {
    std::array<Ints, 3> e = {t.e[0].value, t.e[1].value, t.e[2].value};
    for (std::int32_t column = 0; column <= columns; ++column) {
      // Negative: outside an edge, or beyond the lane's own pixels.
      const Ints outside =
          (e[0] | e[1] | e[2]) | ((t.columns - Ints(column)) | (t.rows - Ints(row)));
      const Truth hit = outside >= Ints(0);
      if (any(hit)) {
        hits.add(hit, place_in_tile(tile, t.left + Ints(column), t.top + Ints(row)),
                 t.depth.at(e[1] + t.e[1].lessened, e[2] + t.e[2].lessened), t.key);
      }
      for (std::size_t i = 0; i < 3; ++i) e[i] = e[i] + t.e[i].step_x;
    }
    for (LaneEdge& edge : t.e) edge.value = edge.value + edge.step_y;
  }
}

inline void draw_small(const Tile& tile, const PackedTriangles& triangles, bool skip_hidden,
                       HitList& hits) {
  for (int from = 0; from < triangles.count; from += lanes) {
    walk_small(tile, load_small(triangles, from, tile, skip_hidden), hits);
  }
  hits.write();
}

}  // namespace rasterlab::RASTERLAB_SIMD

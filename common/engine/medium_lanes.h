// Triangles of up to 63 pixels a side, set up side by side, to be drawn one after the other.
#pragma once

#include "common/engine/lane_triangles.h"

namespace rasterlab::RASTERLAB_SIMD {

/// As many triangles as there are lanes, as arrays.
struct MediumLanes {
  using Values = std::array<std::int32_t, lanes>;
  using Numbers = std::array<float, lanes>;

  std::array<Values, 3> value;  ///< of edge functions at the tile's first pixel
  std::array<Values, 3> lessened;
  std::array<Values, 3> step_x;
  std::array<Values, 3> step_y;
  Values left, right, top, bottom;
  Numbers d0, k1, k2, far, near;

  MediumLanes(const PackedTriangles& triangles, int from, const Tile& tile) {
    const LaneTriangles t(triangles, from);
    const LaneCorners& corners = t.corners;
    const LaneBounds bounds(corners, tile.size, tile.size);
    store(bounds.left, left.data());
    store(bounds.right, right.data());
    store(bounds.top, top.data());
    store(bounds.bottom, bottom.data());
    for (std::size_t i = 0; i < 3; ++i) {
      const LaneEdge edge(corners, i, Ints(128), Ints(128));
      store(edge.value, value[i].data());
      store(edge.lessened, lessened[i].data());
      store(edge.step_x, step_x[i].data());
      store(edge.step_y, step_y[i].data());
    }
    const LaneDepth depth(corners, t.depth);
    store(depth.d0, d0.data());
    store(depth.k1, k1.data());
    store(depth.k2, k2.data());
    store(depth.bounds.near, near.data());
    store(depth.bounds.far, far.data());
  }
};

}  // namespace rasterlab::RASTERLAB_SIMD

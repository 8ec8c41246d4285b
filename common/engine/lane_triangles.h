// Triangles of bins set up, as many at once as there are lanes.
#pragma once

#include "common/engine/depth_bounds.h"
#include "common/engine/kernels.h"
#include "common/engine/simd.h"

#include <algorithm>

namespace rasterlab::RASTERLAB_SIMD {

/// Coordinates from the tile's corner, in 1/256 pixel.
struct LaneCorners {
  std::array<Ints, 3> x;
  std::array<Ints, 3> y;
};

/// What a bin has of them.
struct LaneTriangles {
  LaneCorners corners;
  std::array<Number, 3> depth;
  Ints key;

  /// Those from number `from` on; lanes beyond the last one repeat it, whose memory is near.
  LaneTriangles(const PackedTriangles& triangles, int from) {
    const auto words = [&](std::size_t lane) {
      const int number = std::min(from + static_cast<int>(lane), triangles.count - 1);
      return reinterpret_cast<const float*>(&triangles.triangle[static_cast<std::size_t>(number)]);
    };
    std::array<Number, 8> word;
    load_fours(words, &word[0]);
    load_fours([&](std::size_t lane) { return words(lane) + 4; }, &word[4]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Ints packed = bit_pattern(word[i]);
      corners.x[i] = shift_right<16>(shift_left<16>(packed));
      corners.y[i] = shift_right<16>(packed);
      depth[i] = word[3 + i];
    }
    key = bit_pattern(word[6]);
  }
};

inline Ints smallest_of(const std::array<Ints, 3>& a) {
  return minimum(minimum(a[0], a[1]), a[2]);
}
inline Ints largest_of(const std::array<Ints, 3>& a) {
  return maximum(maximum(a[0], a[1]), a[2]);
}

/// First and last pixels whose centres are within the bounds, cut to `columns` × `rows`.
struct LaneBounds {
  Ints left, right, top, bottom;

  LaneBounds(const LaneCorners& c, int columns, int rows)
      : left(maximum(shift_right<8>(smallest_of(c.x) + Ints(127)), Ints(0))),
        right(minimum(shift_right<8>(largest_of(c.x) - Ints(128)), Ints(columns - 1))),
        top(maximum(shift_right<8>(smallest_of(c.y) + Ints(127)), Ints(0))),
        bottom(minimum(shift_right<8>(largest_of(c.y) - Ints(128)), Ints(rows - 1))) {}
};

/// An edge function, in 32 bits: exact where those hold it, as they do in the box around any
/// triangle that is drawn this way.
struct LaneEdge {
  Ints value;     ///< at the place asked for, less what makes the boundary belong elsewhere
  Ints lessened;  ///< 0 or 1: by how much
  Ints step_x;    ///< per pixel
  Ints step_y;

  /// The one that faces corner i, at (px, py).
  LaneEdge(const LaneCorners& c, std::size_t i, Ints px, Ints py) {
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    const Ints dx = c.x[b] - c.x[a];
    const Ints dy = c.y[b] - c.y[a];
    const Truth owns = dy < Ints(0) || (dy == Ints(0) && dx > Ints(0));
    lessened = select(owns, Ints(0), Ints(1));
    step_x = shift_left<8>(Ints(0) - dy);
    step_y = shift_left<8>(dx);
    value = dx * (py - c.y[a]) - dy * (px - c.x[a]) - lessened;
  }
};

/// From edge functions 1 and 2 to depth.
struct LaneDepth {
  Number d0, k1, k2;
  DepthBounds<Number> bounds;

  LaneDepth(const LaneCorners& c, const std::array<Number, 3>& depth)
      : d0(depth[0]), bounds(bounds_of(depth)) {
    const Ints area = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.y[1] - c.y[0]) * (c.x[2] - c.x[0]);
    const Doubles inverse = Doubles(1) / to_doubles(area);
    k1 = to_number((to_doubles(depth[1]) - to_doubles(d0)) * inverse);
    k2 = to_number((to_doubles(depth[2]) - to_doubles(d0)) * inverse);
  }

  Number at(Ints e1, Ints e2) const { return d0 + (as_numbers(e1) * k1 + as_numbers(e2) * k2); }
};

}  // namespace rasterlab::RASTERLAB_SIMD

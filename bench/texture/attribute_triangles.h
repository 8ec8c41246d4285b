// Triangles in perspective with texture coordinates, and what those are at a pixel: by the
// definition, and by each model that spares divisions.
#pragma once

#include "common/triangles/edge_function.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rasterlab::bench {

struct AttributeCorner {
  double w;
  double u;  ///< in texels
  double v;
};

struct AttributeTriangle {
  SnappedTriangle snapped;
  std::array<AttributeCorner, 3> corners;  ///< floats, held as doubles
};

/// The picture they are in.
inline constexpr int attribute_width = 1920;
inline constexpr int attribute_height = 1080;

/// 40 triangles anywhere in the picture, some 100 pixels large, their w from 1 to `w_ratio`, a
/// texture of 1024 × 1024 texels on them.
std::vector<AttributeTriangle> attribute_triangles(double w_ratio);

/// u and v.
template <class Number>
using Texels = std::array<Number, 2>;

/// At a pixel's centre, each corner counting as its weight on the screen by its w; or, affine, by
/// its weight on the screen alone.
template <class Number>
Texels<Number> texels_at(const AttributeTriangle& triangle, int x, int y, bool affine = false) {
  const TriangleEdges edges = make_edges(triangle.snapped);
  Number u = 0;
  Number v = 0;
  Number sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const AttributeCorner& corner = triangle.corners[i];
    const Number share =
        static_cast<Number>(edges.edges[i].at(x, y)) / Number(affine ? 1 : corner.w);
    u += share * Number(corner.u);
    v += share * Number(corner.v);
    sum += share;
  }
  return {u / sum, v / sum};
}

/// Pixels begin ≤ x < end of a row, divided at every `run_length`-th and at the last, and straight
/// between.
template <class Number>
Texels<Number> texels_in_runs(const AttributeTriangle& triangle, int run_length, int begin, int end,
                              int x, int y) {
  const int from = begin + (x - begin) / run_length * run_length;
  const int to = std::min(from + run_length, end - 1);
  const Texels<Number> a = texels_at<Number>(triangle, from, y);
  if (from >= to) return a;
  const Texels<Number> b = texels_at<Number>(triangle, to, y);
  const Number part = Number(x - from) / Number(to - from);
  return {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part};
}

}  // namespace rasterlab::bench

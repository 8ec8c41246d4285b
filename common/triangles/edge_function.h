// The three lines that bound a triangle, as integer functions of the pixel: Pineda, "A Parallel
// Algorithm for Polygon Rasterization", SIGGRAPH 1988.
#pragma once

#include "common/triangles/fixed_point.h"

#include <array>
#include <cstdint>

namespace rasterlab {

/// Twice the signed area of the triangle (a, b, p), in 1/256 pixel squared, p being the centre of a
/// pixel; linear in the pixel. Positive on the triangle's side of the edge from a to b.
struct EdgeFunction {
  std::int64_t step_x = 0;    ///< from one pixel to the next on the right
  std::int64_t step_y = 0;    ///< from one pixel to the next below
  std::int64_t at_first = 0;  ///< at pixel (0, 0)

  std::int64_t at(int x, int y) const { return at_first + x * step_x + y * step_y; }

  /// Top-left rule: a centre exactly on this edge belongs to the triangle on its right, or below it
  /// when the edge is horizontal. So each of two triangles that share the edge leaves the centre to
  /// the other, or neither does.
  bool owns_boundary() const { return step_x > 0 || (step_x == 0 && step_y > 0); }

  /// The smallest value a covered centre has.
  std::int64_t threshold() const { return owns_boundary() ? 0 : 1; }
};

/// |at()| stays below 2^50: differences of coordinates are at most 2^24, and pixels are taken
/// within the same bounds.
static_assert(max_coordinate * subpixels * 2 <= (1 << 24));

/// Edge i faces corner i, where its function has the value of `twice_area`.
struct TriangleEdges {
  std::array<EdgeFunction, 3> edges;
  std::int64_t twice_area = 0;  ///< in 1/256 pixel squared; 0 covers nothing
};

/// (b − a) × (p − a): positive when p is on the right of the way from a to b, seen with y down.
inline std::int64_t cross(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// The edges of a triangle of either winding.
inline TriangleEdges make_edges(const SnappedTriangle& corners) {
  const SnappedPoint first_center(subpixels / 2, subpixels / 2);
  TriangleEdges triangle;
  const std::int64_t signed_area = cross(corners[0], corners[1], corners[2]);
  const std::int64_t side = signed_area < 0 ? -1 : 1;
  triangle.twice_area = side * signed_area;
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedPoint& a = corners[(i + 1) % 3];
    const SnappedPoint& b = corners[(i + 2) % 3];
    triangle.edges[i] = {.step_x = side * subpixels * (a.y() - b.y()),
                         .step_y = side * subpixels * (b.x() - a.x()),
                         .at_first = side * cross(a, b, first_center)};
  }
  return triangle;
}

}  // namespace rasterlab

// The three lines that bound a triangle, as integer functions of the pixel: Pineda, "A Parallel
// Algorithm for Polygon Rasterization", SIGGRAPH 1988.
#pragma once

#include "common/triangles/fixed_point.h"

#include <array>
#include <cstdint>

namespace rasterlab {

/// Twice the signed area of the triangle (a, b, p), in 1/256 pixel squared, p being the centre of a
/// pixel; linear in the pixel. Positive on the triangle's side of the edge from a to b. Exact in 64
/// bits for corners and pixels within ±32768 pixels, in 128 for ±2^30.
template <class Integer>
struct BasicEdgeFunction {
  Integer step_x = 0;    ///< from one pixel to the next on the right
  Integer step_y = 0;    ///< from one pixel to the next below
  Integer at_first = 0;  ///< at pixel (0, 0)

  Integer at(std::int64_t x, std::int64_t y) const { return at_first + x * step_x + y * step_y; }

  /// Top-left rule: a centre exactly on the edge belongs to the triangle on the edge's right, or
  /// below it where the edge is horizontal. So of two triangles that share the edge exactly one has
  /// the centre.
  bool owns_boundary() const { return step_x > 0 || (step_x == 0 && step_y > 0); }

  /// The smallest value a covered centre has.
  Integer threshold() const { return owns_boundary() ? 0 : 1; }
};
using EdgeFunction = BasicEdgeFunction<std::int64_t>;

// In 64 bits: differences of coordinates stay within 2^24, products within 2^48, and there are no
// more than four of them.
static_assert(max_coordinate * subpixels * 2 <= (1 << 24));

/// Edge i faces corner i, where its function has the value of `twice_area`.
template <class Integer>
struct BasicTriangleEdges {
  std::array<BasicEdgeFunction<Integer>, 3> edges;
  Integer twice_area = 0;  ///< in 1/256 pixel squared; 0 covers nothing
};
using TriangleEdges = BasicTriangleEdges<std::int64_t>;

/// (b − a) × (p − a): positive when p is on the right of the way from a to b, seen with y down.
template <class Integer = std::int64_t>
Integer cross(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& p) {
  return Integer{b.x() - a.x()} * (p.y() - a.y()) - Integer{b.y() - a.y()} * (p.x() - a.x());
}

/// The edges of a triangle of either winding.
template <class Integer = std::int64_t>
BasicTriangleEdges<Integer> make_edges(const SnappedTriangle& corners) {
  const SnappedPoint first_center(subpixels / 2, subpixels / 2);
  BasicTriangleEdges<Integer> triangle;
  const Integer signed_area = cross<Integer>(corners[0], corners[1], corners[2]);
  const Integer side = signed_area < 0 ? -1 : 1;
  triangle.twice_area = side * signed_area;
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedPoint& a = corners[(i + 1) % 3];
    const SnappedPoint& b = corners[(i + 2) % 3];
    triangle.edges[i] = {.step_x = side * subpixels * (a.y() - b.y()),
                         .step_y = side * subpixels * (b.x() - a.x()),
                         .at_first = side * cross<Integer>(a, b, first_center)};
  }
  return triangle;
}

}  // namespace rasterlab

// Which pixels a triangle covers, and with what weights its corners count there: what stages 03 to
// 07 fill triangles with.
#pragma once

#include "common/triangles/edge_function.h"
#include "common/triangles/fixed_point.h"
#include "common/triangles/spans.h"

#include <array>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// Calls `visit(x, y, weights)` for the pixels x of a span [begin, end) of row y.
template <class Integer, class Visit>
void visit_span(const BasicTriangleEdges<Integer>& triangle, int y, int begin, int end,
                Visit&& visit) {
  const auto& edges = triangle.edges;
  const auto area = static_cast<double>(triangle.twice_area);
  std::array<Integer, 3> value = {edges[0].at(begin, y), edges[1].at(begin, y),
                                  edges[2].at(begin, y)};
  for (int x = begin; x < end; ++x) {
    visit(
        x, y,
        Eigen::Vector3d(static_cast<double>(value[0]) / area, static_cast<double>(value[1]) / area,
                        static_cast<double>(value[2]) / area));
    for (std::size_t i = 0; i < 3; ++i) value[i] += edges[i].step_x;
  }
}

/// Calls `visit(x, y, weights)` once for every pixel of a width × height image whose centre the
/// triangle covers, row by row from the top, each row from left to right.
///
/// `corners` are in window coordinates: pixels, y down, pixel (x, y) having its centre at (x + ½, y
/// + ½). They are snapped to 1/256 pixel, round-to-nearest-even; coverage is decided by integer
/// edge functions with the top-left rule, so triangles that share an edge leave no gap and cover no
/// pixel twice. Either winding covers the same; zero area covers nothing. `weights`
/// (Eigen::Vector3d) are the screen-space barycentric weights of the pixel's centre in the snapped
/// triangle, one per corner in the order given, each the correctly rounded quotient of two exact
/// integers; they sum to 1 up to rounding.
///
/// Throws CheckError when a coordinate is beyond ±32768 or not a number. Cost: rows + covered
/// pixels.
template <class Visit>
void rasterize_triangle(const std::array<Eigen::Vector2f, 3>& corners, int width, int height,
                        Visit&& visit) {
  const SnappedTriangle snapped = snap(corners);
  const TriangleEdges triangle = make_edges(snapped);
  for_each_span(snapped, width, height,
                [&](int y, int begin, int end) { visit_span(triangle, y, begin, end, visit); });
}

/// The same for corners within ±2^30 pixels, in 128-bit integers where 64 are not enough; weights
/// are then as near as a double quotient is. Throws CheckError beyond.
template <class Visit>
void rasterize_wide_triangle(const Corners& corners, int width, int height, Visit&& visit) {
  const SnappedTriangle snapped = snap(corners, max_wide_coordinate);
  if (within(corners, max_coordinate)) {
    const auto triangle = make_edges(snapped);
    for_each_span(snapped, width, height,
                  [&](int y, int begin, int end) { visit_span(triangle, y, begin, end, visit); });
  } else {
    const auto triangle = make_edges<Int128>(snapped);
    for_each_span_in_128_bits(snapped, width, height, [&](int y, int begin, int end) {
      visit_span(triangle, y, begin, end, visit);
    });
  }
}

}  // namespace rasterlab

// Which pixels a triangle covers, and with what weights its corners count there: what stages 03 to
// 07 fill triangles with.
#pragma once

#include "common/triangles/edge_function.h"
#include "common/triangles/fixed_point.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// a / b rounded down, for b > 0.
inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// Calls `visit(y, begin, end)` for every row of a width × height image in which the triangle
/// covers a pixel, from the top down: it covers exactly the pixels begin ≤ x < end of that row.
template <class Visit>
void for_each_span(const SnappedTriangle& corners, const TriangleEdges& triangle, int width,
                   int height, Visit&& visit) {
  if (triangle.twice_area == 0) return;
  const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  // Centres are at 256 i + 128: the first that is not before a coordinate, and the last that is not
  // after it.
  const auto first = [](std::int64_t low) { return std::max<std::int64_t>((low + 127) >> 8, 0); };
  const auto last = [](std::int64_t high, int size) {
    return std::min<std::int64_t>((high - 128) >> 8, size - 1);
  };
  for (std::int64_t y = first(top); y <= last(bottom, height); ++y) {
    std::int64_t begin = first(left);
    std::int64_t end = last(right, width) + 1;
    for (const EdgeFunction& edge : triangle.edges) {
      // The edge's half plane in this row is step_x · x ≥ need.
      const std::int64_t need = edge.threshold() - edge.at(0, static_cast<int>(y));
      if (edge.step_x > 0) {
        begin = std::max(begin, -floor_divide(-need, edge.step_x));
      } else if (edge.step_x < 0) {
        end = std::min(end, floor_divide(-need, -edge.step_x) + 1);
      } else if (need > 0) {
        end = begin;
      }
    }
    if (begin < end) visit(static_cast<int>(y), static_cast<int>(begin), static_cast<int>(end));
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
  const auto& edges = triangle.edges;
  const auto area = static_cast<double>(triangle.twice_area);
  for_each_span(snapped, triangle, width, height, [&](int y, int begin, int end) {
    std::array<std::int64_t, 3> value = {edges[0].at(begin, y), edges[1].at(begin, y),
                                         edges[2].at(begin, y)};
    for (int x = begin; x < end; ++x) {
      visit(x, y,
            Eigen::Vector3d(static_cast<double>(value[0]) / area,
                            static_cast<double>(value[1]) / area,
                            static_cast<double>(value[2]) / area));
      for (std::size_t i = 0; i < 3; ++i) value[i] += edges[i].step_x;
    }
  });
}

}  // namespace rasterlab

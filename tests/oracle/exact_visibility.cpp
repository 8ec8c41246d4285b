#include "tests/oracle/exact_visibility.h"

#include "tests/oracle/exact_triangle.h"

#include <cmath>
#include <optional>

#ifndef __clang__
// g++ 12 takes the small-integer storage inside cpp_int for uninitialized.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>

namespace rasterlab::oracle {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// (b − a) × (p − a).
std::int64_t cross(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
  return static_cast<std::int64_t>((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
}

/// 1/d at the pixel's centre: Σ wᵢ/dᵢ, the weights being quotients of areas.
Rational inverse_distance(const GridTriangle& t, const std::array<float, 3>& distances, int x,
                          int y) {
  const GridPoint center{Int128{256} * x + 128, Int128{256} * y + 128};
  const Rational area = cross(t[0], t[1], t[2]);
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational part = cross(t[(i + 1) % 3], t[(i + 2) % 3], center);
    sum += part / area / Rational(distances[i]);
  }
  return sum;
}

}  // namespace

VisibleTriangles exactly_seen(const VisibilityScene& scene) {
  VisibleTriangles seen(scene.width, scene.height, -1);
  std::vector<GridTriangle> grid;
  for (const VisibilityTriangle& triangle : scene.triangles) {
    grid.push_back(to_grid({triangle.corners[0].cast<double>(), triangle.corners[1].cast<double>(),
                            triangle.corners[2].cast<double>()}));
  }
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      Rational nearest = 0;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        if (!covers(grid[i], x, y)) continue;
        const Rational candidate = inverse_distance(grid[i], scene.triangles[i].distances, x, y);
        if (seen(x, y) >= 0 && candidate <= nearest) continue;
        nearest = candidate;
        seen(x, y) = static_cast<std::int32_t>(i);
      }
    }
  }
  return seen;
}

}  // namespace rasterlab::oracle

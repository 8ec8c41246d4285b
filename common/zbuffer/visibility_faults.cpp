#include "common/zbuffer/visibility_faults.h"

#include "common/image/check.h"
#include "common/triangles/edge_function.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

namespace rasterlab {
namespace {

/// A positive fraction.
struct Fraction {
  Int128 above;
  Int128 below;
};

/// A triangle in integers: edge functions, and distances in sixteenths.
struct IntegerTriangle {
  TriangleEdges edges;
  std::array<std::int64_t, 3> distances{};

  explicit IntegerTriangle(const VisibilityTriangle& triangle)
      : edges(make_edges(snap(triangle.corners, 256))) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float sixteenths = triangle.distances[i] * 16;
      if (sixteenths != std::round(sixteenths) || !(sixteenths > 0 && sixteenths < 256)) {
        throw CheckError(
            "distances must be multiples of 1/16 between 0 and 16 to be compared exactly");
      }
      distances[i] = static_cast<std::int64_t>(sixteenths);
    }
  }

  /// 1/d = Σ wᵢ/dᵢ at the centre of a pixel: Σ Eᵢ dⱼ dₖ over 2 area d₀ d₁ d₂, at most 2^52 over
  /// 2^60. Nothing where the triangle does not cover it.
  std::optional<Fraction> inverse_distance(int x, int y) const {
    if (edges.twice_area == 0) return std::nullopt;
    Fraction sum{0, Int128{edges.twice_area} * distances[0] * distances[1] * distances[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t value = edges.edges[i].at(x, y);
      if (value < edges.edges[i].threshold()) return std::nullopt;
      sum.above += Int128{value} * distances[(i + 1) % 3] * distances[(i + 2) % 3];
    }
    return sum;
  }
};

}  // namespace

VisibilityFaults visibility_faults(const VisibleTriangles& seen, const VisibilityScene& scene) {
  std::vector<IntegerTriangle> triangles;
  for (const VisibilityTriangle& triangle : scene.triangles) triangles.emplace_back(triangle);
  VisibilityFaults faults;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      std::optional<Fraction> shown;
      if (seen(x, y) >= 0)
        shown = triangles[static_cast<std::size_t>(seen(x, y))].inverse_distance(x, y);
      bool covered = false;
      bool wrong = !shown && seen(x, y) >= 0;
      for (const IntegerTriangle& triangle : triangles) {
        const std::optional<Fraction> other = triangle.inverse_distance(x, y);
        if (!other) continue;
        covered = true;
        wrong |= !shown || other->above * shown->below > shown->above * other->below;
      }
      faults.covered += covered ? 1 : 0;
      faults.wrong += wrong ? 1 : 0;
    }
  }
  return faults;
}

VisibilityScene piercing_triangles() {
  std::mt19937 random(3);
  // Not std::uniform_real_distribution, whose values differ between libraries.
  const auto below = [&](unsigned count) { return static_cast<float>(random() % count); };
  VisibilityScene scene{.width = 128, .height = 128, .near = 1, .far = 10, .triangles = {}};
  for (int i = 0; i < 30; ++i) {
    VisibilityTriangle& triangle = scene.triangles.emplace_back();
    for (Eigen::Vector2f& corner : triangle.corners) {
      corner.x() = below(128 * subpixels) / subpixels;
      corner.y() = below(128 * subpixels) / subpixels;
    }
    for (float& distance : triangle.distances) distance = 1 + below(9 * 16) / 16;
  }
  return scene;
}

VisibilityScene nearly_coplanar_pair(double distance, double delta, bool nearer_last) {
  VisibilityScene scene{.width = 32, .height = 32, .near = 0.5F, .far = 50000, .triangles = {}};
  for (const bool nearer : {!nearer_last, nearer_last}) {
    const double scale = nearer ? distance : distance * (1 + delta);
    VisibilityTriangle& triangle = scene.triangles.emplace_back();
    triangle.corners = {Eigen::Vector2f(1, 2), Eigen::Vector2f(31, 10), Eigen::Vector2f(5, 30)};
    triangle.distances = {static_cast<float>(scale), static_cast<float>(1.5 * scale),
                          static_cast<float>(2 * scale)};
  }
  return scene;
}

double wrong_share_of_pair(VisibilityFunction rung, double distance, double delta) {
  int wrong = 0;
  int covered = 0;
  for (const bool nearer_last : {false, true}) {
    const VisibleTriangles seen = rung(nearly_coplanar_pair(distance, delta, nearer_last));
    for (const std::int32_t shown : seen.pixels()) {
      if (shown < 0) continue;
      ++covered;
      if (shown != (nearer_last ? 1 : 0)) ++wrong;
    }
  }
  return static_cast<double>(wrong) / covered;
}

std::string visibility_fault_table() {
  char cell[96];
  std::string table = "random triangles that pierce each other: pixels that show the wrong one\n";
  const VisibilityScene scene = piercing_triangles();
  for (const VisibilityRung& rung : visibility_ladder) {
    const VisibilityFaults faults = visibility_faults(rung.seen(scene), scene);
    std::snprintf(cell, sizeof cell, "  %-18s %6lld of %lld\n", rung.name,
                  static_cast<long long>(faults.wrong), static_cast<long long>(faults.covered));
    table += cell;
  }
  table += "\ntwo triangles, one (1 + delta) times as far as the other: wrong pixels in percent\n";
  for (const VisibilityRung& rung : visibility_ladder) {
    table +=
        std::string(rung.name) + "\n  distance  delta 1e-2   1e-3   1e-4   1e-5   1e-6   1e-7\n";
    for (const double distance : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
      std::snprintf(cell, sizeof cell, "  %8g      ", distance);
      table += cell;
      for (const double delta : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        std::snprintf(cell, sizeof cell, " %6.1f",
                      100 * wrong_share_of_pair(rung.seen, distance, delta));
        table += cell;
      }
      table += "\n";
    }
  }
  return table;
}

}  // namespace rasterlab

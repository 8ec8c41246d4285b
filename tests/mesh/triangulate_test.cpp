#include "common/mesh/triangulate.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Polygon = std::vector<Eigen::Vector3f>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const Polygon& polygon) {
  Triangles triangles;
  triangulate(polygon, triangles);
  return triangles;
}

Eigen::Vector3d area_vector(const Polygon& polygon, const std::vector<std::uint32_t>& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += polygon[corners[i]].cast<double>().cross(
        polygon[corners[(i + 1) % corners.size()]].cast<double>());
  }
  return sum / 2;
}

/// Nothing covered twice or from behind, nothing left out: the unsigned areas add up to the
/// polygon's.
void expect_exact_cover(const Polygon& polygon) {
  std::vector<std::uint32_t> all(polygon.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const Eigen::Vector3d whole = area_vector(polygon, all);
  double sum = 0;
  const Triangles triangles = cut(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d part = area_vector(polygon, {a, b, c});
    EXPECT_GE(part.dot(whole), -1e-6 * whole.squaredNorm()) << "a triangle is turned round";
    sum += part.norm();
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-5 * whole.norm());
}

TEST(stage01_triangulate, convex_is_a_fan) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(stage01_triangulate, concave_quads_of_any_first_corner) {
  const Polygon arrow = {{0, 0, 0}, {2, -1, 0}, {0.5F, 0, 0}, {2, 1, 0}};
  for (std::size_t first = 0; first < 4; ++first) {
    Polygon turned = arrow;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    expect_exact_cover(turned);
    std::reverse(turned.begin(), turned.end());
    expect_exact_cover(turned);
  }
}

TEST(stage01_triangulate, letters_in_any_plane) {
  const std::vector<Eigen::Vector2f> comb = {{0, 0}, {7, 0}, {7, 4}, {6, 4}, {6, 1}, {5, 1},
                                             {5, 4}, {4, 4}, {4, 1}, {3, 1}, {3, 4}, {2, 4},
                                             {2, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0F, -1.0F}) {
      Polygon polygon;
      for (const auto& point : comb) {
        Eigen::Vector3f corner = Eigen::Vector3f::Constant(5);
        corner[(axis + 1) % 3] = sign * point.x();
        corner[(axis + 2) % 3] = point.y();
        polygon.push_back(corner);
      }
      expect_exact_cover(polygon);
    }
  }
}

TEST(stage01_triangulate, a_hole_joined_by_a_cut) {
  // The outer square, then along the cut to the inner one and back: two corners are passed twice.
  expect_exact_cover({{0, 0, 0},
                      {4, 0, 0},
                      {4, 4, 0},
                      {0, 4, 0},
                      {0, 0, 0},
                      {1, 1, 0},
                      {1, 3, 0},
                      {3, 3, 0},
                      {3, 1, 0},
                      {1, 1, 0}});
}

TEST(stage01_triangulate, random_stars) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    Polygon polygon;
    const std::size_t corners = 4 + random() % 40;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 6.283185307 * static_cast<double>(i) / static_cast<double>(corners);
      const double radius = 0.1 + static_cast<double>(random() % 1000) / 1000;
      polygon.emplace_back(radius * std::cos(angle), 0.5 * radius * std::cos(angle) + 3,
                           radius * std::sin(angle));
    }
    expect_exact_cover(polygon);
  }
}

TEST(stage01_triangulate, whatever_comes_gives_triangles) {
  const Polygon bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(cut(bow_tie).size(), 2U);
  EXPECT_EQ(cut(Polygon(5, Eigen::Vector3f(1, 2, 3))).size(), 3U);
  Polygon line;
  for (int i = 0; i < 6; ++i) line.emplace_back(i, i, i);
  EXPECT_EQ(cut(line).size(), 4U);
  Polygon large;
  for (int i = 0; i < 100000; ++i) large.emplace_back(i, i % 2, 0);
  EXPECT_EQ(cut(large).size(), large.size() - 2);
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    Polygon polygon;
    for (int i = 0; i < 30; ++i) {
      polygon.emplace_back(random() % 8, random() % 8, random() % 8);
    }
    for (const auto& triangle : cut(polygon)) {
      for (const std::uint32_t corner : triangle) EXPECT_LT(corner, polygon.size());
    }
    EXPECT_EQ(cut(polygon).size(), polygon.size() - 2);
  }
}

}  // namespace
}  // namespace rasterlab

// The witness itself, against closed forms: what it says about others is worth what this says about
// it.
#include "tests/oracle/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

Mesh one_triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Triangles of about unit size around the origin.
Mesh random_soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Eigen::Vector3f center(place(random), place(random), place(random));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.emplace_back(
          center + 0.3F * Eigen::Vector3f(place(random), place(random), place(random)));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Camera three_quarter_view() {
  return {.view = look_at({2, 1.5, 2.5}, {0.1, 0, -0.1}, {0, 1, 0}),
          .projection = perspective(40, 4.0 / 3, 0.1, 20)};
}

TEST(oracle_ray_caster, wall_across_the_view_is_equally_far_everywhere) {
  const Mesh wall = one_triangle({-100, -100, -3}, {100, -100, -3}, {0, 200, -3});
  const RayCaster caster(wall, {.projection = perspective(90, 1, 0.1, 20)}, 20, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) EXPECT_NEAR(caster.cast(x + 0.5, y + 0.5).distance, 3, 1e-12);
  }
}

TEST(oracle_ray_caster, weights_are_those_of_the_point_in_space) {
  // A floor at y = −1 seen from the origin: window row y meets it at distance 1 / (2 (y − 50) /
  // 100).
  const Mesh floor = one_triangle({-40, -1, -1}, {40, -1, -1}, {0, -1, -11});
  const RayCaster caster(floor, {.projection = perspective(90, 1, 0.1, 200)}, 100, 100);
  for (const double y : {60.0, 62.5, 75.0, 99.0}) {
    const double distance = 50 / (y - 50);
    const Hit hit = caster.cast(50, y);
    EXPECT_EQ(hit.face, 0);
    EXPECT_NEAR(hit.distance, distance, 1e-12);
    EXPECT_NEAR(hit.weights[2], (distance - 1) / 10, 1e-12);
    EXPECT_NEAR(hit.weights.sum(), 1, 1e-12);
    EXPECT_NEAR(hit.weights[0], hit.weights[1], 1e-12);
  }
}

TEST(oracle_ray_caster, the_nearer_and_only_what_lies_between_near_and_far_is_seen) {
  Mesh mesh;
  for (const float z : {-0.05F, -9.0F, -3.0F, -5.0F, 2.0F, -50.0F}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(RayCaster(mesh, {.projection = perspective(60, 1, 0.1, 20)}, 9, 9).cast(4.5, 4.5).face,
            2);
  EXPECT_EQ(RayCaster(mesh, {.projection = perspective(60, 1, 4, 20)}, 9, 9).cast(4.5, 4.5).face,
            3);
  EXPECT_EQ(RayCaster(mesh, {.projection = perspective(60, 1, 10, 20)}, 9, 9).cast(4.5, 4.5).face,
            -1);
  const double infinity = std::numeric_limits<double>::infinity();
  const Hit far =
      RayCaster(mesh, {.projection = perspective(60, 1, 10, infinity)}, 9, 9).cast(4.5, 4.5);
  EXPECT_EQ(far.face, 5);
  EXPECT_NEAR(far.distance, 50, 1e-9);
}

TEST(oracle_ray_caster, orthographic_rays_are_parallel) {
  const Mesh mesh = one_triangle({-1, -1, -2}, {1, -1, -2}, {-1, 1, -4});
  const RayCaster caster(mesh, {.projection = orthographic(2, 1, 1, 10)}, 10, 10);
  const Hit hit = caster.cast(2.5, 7.5);  // NDC (−0.5, −0.5)
  EXPECT_NEAR(hit.distance, 2.5, 1e-12);
  EXPECT_TRUE(hit.weights.isApprox(Eigen::Vector3d(0.5, 0.25, 0.25), 1e-12));
}

TEST(oracle_ray_caster, facing_is_toward_the_eye_and_culling_honours_it) {
  const Mesh toward = one_triangle({-1, -1, -2}, {1, -1, -2}, {0, 1, -2});
  const Mesh away = one_triangle({1, -1, -2}, {-1, -1, -2}, {0, 1, -2});
  const Camera camera{.projection = perspective(60, 1, 0.1, 20)};
  EXPECT_TRUE(RayCaster(toward, camera, 9, 9).cast(4.5, 4.5).front);
  EXPECT_FALSE(RayCaster(away, camera, 9, 9).cast(4.5, 4.5).front);
  EXPECT_EQ(RayCaster(toward, camera, 9, 9, Cull::back).cast(4.5, 4.5).face, 0);
  EXPECT_EQ(RayCaster(away, camera, 9, 9, Cull::back).cast(4.5, 4.5).face, -1);
  EXPECT_EQ(RayCaster(toward, camera, 9, 9, Cull::front).cast(4.5, 4.5).face, -1);
}

TEST(oracle_ray_caster, tree_finds_what_trying_every_face_finds) {
  const Mesh soup = random_soup(300, 1);
  const RayCaster caster(soup, three_quarter_view(), 40, 30);
  int hits = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      Hit nearest;
      for (int face = 0; face < 300; ++face) {
        const Hit hit = caster.cast_plane(x + 0.5, y + 0.5, face);
        if (caster.covers(x + 0.5, y + 0.5, face) && hit.ray_parameter < nearest.ray_parameter)
          nearest = hit;
      }
      EXPECT_EQ(caster.cast(x + 0.5, y + 0.5).face, nearest.face)
          << "pixel (" << x << ", " << y << ")";
      hits += nearest.face >= 0 ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(oracle_ray_caster, edge_distances_are_those_to_the_projected_segments) {
  const Mesh mesh = one_triangle({-0.7F, -0.3F, -2}, {0.9F, -0.5F, -1.5F}, {0.2F, 0.8F, -3});
  const RayCaster caster(mesh, {.projection = perspective(70, 1.25, 0.1, 20)}, 50, 40);
  const std::vector<double> distances = caster.edge_distances();
  const double scale = 1 / std::tan(35 * std::numbers::pi / 180);
  std::array<Eigen::Vector2d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d p = mesh.positions[i].cast<double>();
    corners[i] = {25 * (1 + scale / 1.25 * p.x() / -p.z()), 20 * (1 - scale * p.y() / -p.z())};
  }
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 50; ++x) {
      const Eigen::Vector2d center(x + 0.5, y + 0.5);
      double expected = Hit::nothing;
      for (int step = 0; step <= 30000; ++step) {  // brute force: 10 000 points on each side
        const auto side = static_cast<std::size_t>(std::min(step / 10000, 2));
        const double t = (step - 10000.0 * static_cast<double>(side)) / 10000;
        expected = std::min(
            expected, (center - (1 - t) * corners[side] - t * corners[(side + 1) % 3]).norm());
      }
      const double distance = distances[static_cast<std::size_t>(y * 50 + x)];
      if (expected < 0.999) {
        EXPECT_NEAR(distance, expected, 2e-3) << "pixel (" << x << ", " << y << ")";
      } else if (expected > 1.001) {
        EXPECT_EQ(distance, Hit::nothing) << "pixel (" << x << ", " << y << ")";
      }
    }
  }
}

TEST(oracle_ray_caster, edges_made_by_the_near_plane_count_and_those_behind_the_eye_do_not) {
  // A floor from behind the eye to 10 in front, cut at the near plane 1: its outline ends on row 50
  // + 50 = the bottom.
  const Mesh floor = one_triangle({-50, -0.5F, 10}, {50, -0.5F, 10}, {0, -0.5F, -10});
  const RayCaster caster(floor, {.projection = perspective(90, 1, 1, 100)}, 100, 100);
  const std::vector<double> distances = caster.edge_distances();
  EXPECT_NEAR(distances[75 * 100 + 40], 0.5,
              1e-9);  // the cut is seen at y = 50 · (1 + 0.5 / 1) = 75
  EXPECT_EQ(caster.cast(40.5, 74.5).face, 0);
  EXPECT_EQ(caster.cast(40.5, 75.5).face, -1);
  EXPECT_EQ(distances[90 * 100 + 40], Hit::nothing);
}

TEST(oracle_ray_caster, hidden_edges_do_not_count) {
  Mesh mesh = one_triangle({-9, -9, -2}, {9, -9, -2}, {0, 18, -2});
  mesh.positions.insert(mesh.positions.end(), {{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}});
  mesh.triangles.push_back({3, 4, 5});
  const RayCaster caster(mesh, {.projection = perspective(60, 1, 0.1, 20)}, 40, 40);
  for (const double distance : caster.edge_distances()) EXPECT_EQ(distance, Hit::nothing);
}

TEST(oracle_ray_caster, crossing_planes_are_told_by_their_line) {
  // Two planes that cross on the window's vertical line through its middle, tilted against each
  // other.
  Mesh mesh = one_triangle({-1, -1, -1.5F}, {1, -1, -2.5F}, {0, 1, -2});
  mesh.positions.insert(mesh.positions.end(), {{-1, -1, -2.5F}, {1, -1, -1.5F}, {0, 1, -2}});
  mesh.triangles.push_back({3, 4, 5});
  const RayCaster caster(mesh, {.projection = perspective(60, 1, 0.1, 20)}, 40, 40);
  EXPECT_NEAR(caster.crossing_distance(20.25, 20, 0, 1), 0.25, 1e-9);
  EXPECT_NEAR(caster.crossing_distance(17, 25, 0, 1), 3, 1e-9);
  EXPECT_EQ(caster.crossing_distance(20, 11, 0, 1), 0);
}

/// The corners of a triangle in the window of 40 × 40 pixels, all at the same distance.
Mesh flat_triangle(const std::array<Eigen::Vector2d, 3>& window) {
  Mesh mesh;
  for (const Eigen::Vector2d& corner : window) {
    mesh.positions.emplace_back(static_cast<float>(corner.x() / 20 - 1),
                                static_cast<float>(1 - corner.y() / 20), -2.0F);
  }
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(oracle_ray_caster, corners_near_a_tie_can_be_snapped_in_two_ways) {
  const Camera camera{.projection = orthographic(2, 1, 1, 10)};
  const double unit = 1.0 / 256;
  const RayCaster plain(flat_triangle({{{4, 4}, {4, 36 + 0.4 * unit}, {36, 4}}}), camera, 40, 40);
  EXPECT_EQ(plain.snappings(0), 1);
  const RayCaster doubtful(
      flat_triangle({{{4, 4}, {4, 36 + 0.4999 * unit}, {36 - 0.5001 * unit, 4}}}), camera, 40, 40);
  EXPECT_EQ(doubtful.snappings(0), 4);
  const std::array<Eigen::Vector2d, 4> far_sides{
      {{36 - unit, 36}, {36 - unit, 36 + unit}, {36, 36}, {36, 36 + unit}}};
  std::vector<Eigen::Vector2d> found;
  for (int snapping = 0; snapping < 4; ++snapping) {
    const Hit hit = doubtful.drawn_plane(12, 20, 0, snapping);
    found.emplace_back(4 + 8 / hit.weights[2], 4 + 16 / hit.weights[1]);
  }
  for (const Eigen::Vector2d& sides : far_sides) {
    EXPECT_TRUE(std::ranges::any_of(found, [&](const Eigen::Vector2d& other) {
      return (other - sides).norm() < 1e-9;
    })) << sides.transpose();
  }
}

TEST(oracle_ray_caster, affine_weights_are_those_in_the_window) {
  // The floor of weights_are_those_of_the_point_in_space: seen from row 100 to row 54 + 6/11.
  const Mesh floor = one_triangle({-1, -1, -1}, {1, -1, -1}, {0, -1, -11});
  const RayCaster caster(floor, {.projection = perspective(90, 1, 0.1, 200)}, 100, 100);
  const double top = std::nearbyint((50 + 50.0 / 11) * 256) / 256;
  for (const double y : {60.0, 75.0, 99.0}) {
    EXPECT_NEAR(caster.affine_plane(50, y, 0).weights[2], (100 - y) / (100 - top), 1e-12);
  }
}

TEST(oracle_ray_caster, cameras_put_points_where_they_belong) {
  const Eigen::Matrix4d view = look_at({1, 1, 2}, {0.5, 0, 0}, {0, 1, 0});
  EXPECT_TRUE((view * Eigen::Vector4d(1, 1, 2, 1)).isApprox(Eigen::Vector4d(0, 0, 0, 1)));
  const Eigen::Vector4d center = view * Eigen::Vector4d(0.5, 0, 0, 1);
  EXPECT_NEAR(center.head<2>().norm(), 0, 1e-12);
  EXPECT_NEAR(center.z(), -std::sqrt(5.25), 1e-12);
  EXPECT_NEAR((view.topLeftCorner<3, 3>().determinant()), 1, 1e-12);
  EXPECT_GT((view * Eigen::Vector4d(0, 1, 0, 0)).y(), 0);
  const Eigen::Matrix4d projection = perspective(60, 2, 0.1, 20);
  const Eigen::Vector4d top_right =
      projection *
      Eigen::Vector4d(2 * std::tan(std::numbers::pi / 6), std::tan(std::numbers::pi / 6), -1, 1);
  EXPECT_TRUE((top_right.head<2>() / top_right.w()).isApprox(Eigen::Vector2d(1, 1)));
  for (const auto& [z, depth] : {std::pair{-0.1, -1.0}, {-20.0, 1.0}}) {
    const Eigen::Vector4d clip = projection * Eigen::Vector4d(0, 0, z, 1);
    EXPECT_NEAR(clip.z() / clip.w(), depth, 1e-12);
  }
}

}  // namespace
}  // namespace rasterlab::oracle

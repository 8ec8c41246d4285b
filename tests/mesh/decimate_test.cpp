#include "common/mesh/decimate.h"

#include "common/mesh/shapes.h"

#include <map>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// How often each directed edge, between positions, is a triangle's.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Mesh& mesh) {
  const std::vector<std::uint32_t> joined = join_by_position(mesh.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[{joined[triangle[i]], joined[triangle[(i + 1) % 3]]}];
  }
  return edges;
}

/// Of a closed mesh, six times.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.positions[a].cast<double>().dot(
        mesh.positions[b].cast<double>().cross(mesh.positions[c].cast<double>()));
  }
  return sum;
}

TEST(stage01_decimate, has_as_many_triangles_as_asked_for_and_stays_closed) {
  const Mesh sphere = make_shape("uv_sphere:24");
  for (const std::size_t triangles : {1000U, 200U, 40U}) {
    const Mesh fewer = decimated(sphere, triangles);
    EXPECT_LE(fewer.triangles.size(), triangles);
    EXPECT_GE(fewer.triangles.size(), triangles - 2);
    const auto edges = directed_edges(fewer);
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << "a hole";
    }
    EXPECT_EQ(fewer.normals.size(), fewer.positions.size());
  }
}

TEST(stage01_decimate, vertices_are_the_mesh_s_own_and_the_shape_is_kept) {
  const Mesh sphere = make_shape("icosphere:4");
  const Mesh fewer = decimated(sphere, 1000);
  for (const Eigen::Vector3f& position : fewer.positions) {
    EXPECT_NE(std::find(sphere.positions.begin(), sphere.positions.end(), position),
              sphere.positions.end());
  }
  EXPECT_GT(volume(fewer), 0.98 * volume(sphere));
}

TEST(stage01_decimate, a_flat_square_needs_two_triangles) {
  const Mesh fewer = decimated(make_shape("wall:8"), 2);
  EXPECT_EQ(fewer.triangles.size(), 2U);
  for (const Eigen::Vector3f& normal : fewer.normals) EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
}

TEST(stage01_decimate, keeps_what_is_asked_for_where_edges_have_three_faces) {
  Mesh fan;
  fan.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0.5F}, {0, 0, 1}};
  fan.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 2, 1}};
  EXPECT_EQ(decimated(fan, 100).triangles.size(), 3U);
  EXPECT_TRUE(decimated(Mesh(), 10).empty());
}

}  // namespace
}  // namespace rasterlab

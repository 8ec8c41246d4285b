#include "common/mesh/normals.h"

#include "common/mesh/shapes.h"

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// A cube whose faces are cut along whichever diagonal, 8 vertices.
Mesh plain_cube(unsigned diagonals) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? 1.0F : -1.0F, (i & 2) != 0 ? 1.0F : -1.0F,
                                (i & 4) != 0 ? 1.0F : -1.0F);
  }
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [a, b, c, d] = faces[i];
    if ((diagonals >> i & 1U) != 0) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    } else {
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({b, c, d});
    }
  }
  return mesh;
}

TEST(stage01_normals, angle_weights_do_not_see_diagonals) {
  for (unsigned diagonals = 0; diagonals < 64; ++diagonals) {
    const Mesh mesh = plain_cube(diagonals);
    const auto normals = angle_weighted_normals(mesh);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_LT((normals[i] - mesh.positions[i].normalized()).norm(), 1e-6F);
    }
  }
}

TEST(stage01_normals, one_normal_across_a_seam) {
  const Mesh sphere = make_shape("uv_sphere:24");
  const auto normals = angle_weighted_normals(sphere);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_LT((normals[i] - sphere.normals[i]).norm(), 0.02F) << "at " << i;
  }
  const auto joined = join_by_position(sphere.positions);
  for (std::size_t i = 0; i < normals.size(); ++i) EXPECT_EQ(normals[i], normals[joined[i]]);
}

TEST(stage01_normals, opposite_faces_fall_back_to_the_first) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const auto normals = angle_weighted_normals(mesh);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(normals[i], Eigen::Vector3f::UnitZ());
  mesh.triangles = {{0, 2, 1}, {0, 1, 2}};
  EXPECT_EQ(angle_weighted_normals(mesh)[0], -Eigen::Vector3f::UnitZ());
}

TEST(stage01_normals, a_face_without_area_weighs_nothing) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {1, 1, 1}};
  EXPECT_EQ(face_normals(mesh)[0], Eigen::Vector3f::Zero());
  for (const auto& normal : angle_weighted_normals(mesh)) {
    EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
  }
}

TEST(stage01_normals, faces_of_any_size_have_a_normal) {
  Mesh mesh;
  for (const float size : {1e-20F, 1.0F, 1e20F}) {
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(face_normals(mesh)[0], Eigen::Vector3f::UnitZ()) << size;
    EXPECT_EQ(angle_weighted_normals(mesh)[0], Eigen::Vector3f::UnitZ()) << size;
  }
}

}  // namespace
}  // namespace rasterlab

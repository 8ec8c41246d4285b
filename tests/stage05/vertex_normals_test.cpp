#include "common/lighting/vertex_normals.h"

#include "common/mesh/normals.h"
#include "common/mesh/shapes.h"

#include <cmath>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

testing::AssertionResult is_near(const Vector& actual, const Vector& expected) {
  if ((actual - expected).norm() < 1e-6F) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "(" << actual.transpose() << ") should be (" << expected.transpose() << ")";
}

// A corner of a cube, its three faces cut into `cuts` triangles each around the corner.
Mesh corner_of_a_cube(const std::vector<int>& cuts) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  for (int axis = 0; axis < 3; ++axis) {
    // The face at a right angle to `axis`, between the other two axes: seen from outside, from the
    // negative side, from the second to the first.
    const Vector from = Vector::Unit((axis + 2) % 3);
    const Vector to = Vector::Unit((axis + 1) % 3);
    const int triangles = cuts[static_cast<std::size_t>(axis)];
    for (int i = 0; i < triangles; ++i) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      const float a = static_cast<float>(i) / static_cast<float>(triangles);
      const float b = static_cast<float>(i + 1) / static_cast<float>(triangles);
      mesh.positions.push_back(from * (1 - a) + to * a);
      mesh.positions.push_back(from * (1 - b) + to * b);
      mesh.triangles.push_back({0, first, first + 1});
    }
  }
  return mesh;
}

const Vector diagonal = -Vector::Ones().normalized();

TEST(stage05_vertex_normals, flat_faces_keep_their_normal_whatever_their_size) {
  for (const float size : {1e-20F, 1e-3F, 1.0F, 1e15F}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.triangles = {{0, 1, 2}};
    for (const Vector& normal : vertex_normals(mesh)) {
      EXPECT_TRUE(is_near(normal, {0, 0, 1})) << "counter-clockwise from +z; size " << size;
    }
  }
}

TEST(stage05_vertex_normals, the_mean_of_three_faces_at_right_angles_is_the_diagonal) {
  EXPECT_TRUE(is_near(vertex_normals(corner_of_a_cube({1, 1, 1}))[0], diagonal));
}

TEST(stage05_vertex_normals, every_face_counts_alike_large_or_small) {
  Mesh mesh = corner_of_a_cube({1, 1, 1});
  mesh.positions[1] *= 1000;
  mesh.positions[2] *= 1000;
  EXPECT_TRUE(is_near(vertex_normals(mesh)[0], diagonal))
      << "make each face's normal a unit vector before it is added";
}

TEST(stage05_vertex_normals, the_mean_depends_on_how_faces_are_cut_and_angles_do_not) {
  const Mesh mesh = corner_of_a_cube({2, 1, 3});
  EXPECT_TRUE(is_near(vertex_normals(mesh)[0], -Vector(2, 1, 3).normalized()));
  EXPECT_TRUE(is_near(angle_weighted_normals(mesh)[0], diagonal));
}

TEST(stage05_vertex_normals, on_a_sphere_they_point_outward_and_are_unit_vectors) {
  const Mesh sphere = make_shape("icosphere", 4);
  const std::vector<Vector> normals = vertex_normals(sphere);
  ASSERT_EQ(normals.size(), sphere.positions.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    ASSERT_NEAR(normals[i].norm(), 1, 1e-6);
    ASSERT_GT(normals[i].dot(sphere.positions[i]), 0.999F);
  }
}

TEST(stage05_vertex_normals, opposite_faces_fall_back_to_the_first) {
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  for (const Vector& normal : vertex_normals(sheet)) EXPECT_TRUE(is_near(normal, {0, 0, 1}));
}

TEST(stage05_vertex_normals, triangles_without_area_do_not_count) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 3}, {1, 1, 2}, {0, 1, 2}};
  const std::vector<Vector> normals = vertex_normals(mesh);
  EXPECT_TRUE(is_near(normals[0], {0, 0, 1}));
  EXPECT_TRUE(is_near(normals[1], {0, 0, 1}));
}

TEST(stage05_vertex_normals, a_vertex_without_a_face_gets_plus_z) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {7, 7, 7}};
  mesh.triangles = {{0, 1, 2}};
  for (const Vector& normal : vertex_normals(mesh)) EXPECT_EQ(normal, Vector(0, 0, 1));
  EXPECT_TRUE(vertex_normals(Mesh()).empty());
}

TEST(stage05_vertex_normals, vertices_are_told_apart_by_index) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<Vector> normals = vertex_normals(mesh);
  EXPECT_TRUE(is_near(normals[0], {0, 0, 1}));
  EXPECT_TRUE(is_near(normals[3], {1, 0, 0})) << "the same place, but the other side of a seam";
}

}  // namespace
}  // namespace rasterlab

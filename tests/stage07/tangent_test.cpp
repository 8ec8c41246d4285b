#include "common/shaders/face_tangent.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Corners = std::array<Eigen::Vector3f, 3>;
using Uvs = std::array<Eigen::Vector2f, 3>;

__extension__ using Quad = __float128;

/// The direction in which u grows while v stays, not normalised, in 113 bits: P is affine in (u,
/// v), and this is ∂P/∂u by Cramer's rule on the three corners' equations.
std::array<Quad, 3> derivative_by_u(const Corners& corners, const Uvs& uv) {
  const auto u = [&](std::size_t i) { return static_cast<Quad>(uv[i].x()); };
  const auto v = [&](std::size_t i) { return static_cast<Quad>(uv[i].y()); };
  const Quad denominator = u(0) * (v(1) - v(2)) + u(1) * (v(2) - v(0)) + u(2) * (v(0) - v(1));
  std::array<Quad, 3> result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto p = [&](std::size_t i) { return static_cast<Quad>(corners[i][axis]); };
    result[static_cast<std::size_t>(axis)] =
        (p(0) * (v(1) - v(2)) + p(1) * (v(2) - v(0)) + p(2) * (v(0) - v(1))) / denominator;
  }
  return result;
}

Corners random_corners(std::mt19937& random) {
  std::uniform_real_distribution<float> value(-1, 1);
  Corners corners;
  for (auto& corner : corners) corner = {value(random), value(random), value(random)};
  return corners;
}

Uvs random_uvs(std::mt19937& random) {
  std::uniform_real_distribution<float> value(0, 1);
  Uvs uvs;
  for (auto& uv : uvs) uv = {value(random), value(random)};
  return uvs;
}

double determinant(const Uvs& uv) {
  const Eigen::Vector2d a = (uv[1].cast<double>() - uv[0].cast<double>());
  const Eigen::Vector2d b = (uv[2].cast<double>() - uv[0].cast<double>());
  return a.x() * b.y() - b.x() * a.y();
}

TEST(stage07_face_tangent, is_the_direction_in_which_u_grows) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const Corners corners = random_corners(random);
    const Uvs uv = random_uvs(random);
    if (std::fabs(determinant(uv)) < 1e-4) continue;
    const auto exact = derivative_by_u(corners, uv);
    const Eigen::Vector3d expected =
        Eigen::Vector3d(static_cast<double>(exact[0]), static_cast<double>(exact[1]),
                        static_cast<double>(exact[2]))
            .normalized();
    const FaceTangent face = face_tangent(corners, uv);
    EXPECT_LE((face.tangent.cast<double>() - expected).norm(), 3e-7);
    EXPECT_EQ(face.handedness, determinant(uv) < 0 ? -1 : 1);
  }
}

TEST(stage07_face_tangent, v_grows_along_handedness_times_normal_cross_tangent) {
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Corners corners = random_corners(random);
    const Uvs uv = random_uvs(random);
    if (std::fabs(determinant(uv)) < 1e-3) continue;
    const FaceTangent face = face_tangent(corners, uv);
    const Eigen::Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    Uvs turned = uv;  // with u and v exchanged, the tangent is where v grows
    for (auto& pair : turned) pair = {pair.y(), pair.x()};
    const Eigen::Vector3f along_v = face_tangent(corners, turned).tangent;
    EXPECT_GT(along_v.dot(face.handedness * normal.cross(face.tangent)), 0);
  }
}

TEST(stage07_face_tangent, a_mirrored_copy_has_the_opposite_tangent_and_handedness) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Corners corners = random_corners(random);
    Uvs uv = random_uvs(random);
    if (std::fabs(determinant(uv)) < 1e-3) continue;
    const FaceTangent face = face_tangent(corners, uv);
    for (auto& pair : uv) pair.x() = -pair.x();
    const FaceTangent mirrored = face_tangent(corners, uv);
    EXPECT_EQ(mirrored.tangent, -face.tangent);
    EXPECT_EQ(mirrored.handedness, -face.handedness);
  }
}

TEST(stage07_face_tangent, degenerate_texture_coordinates_give_some_direction_of_the_face) {
  const Corners corners = {Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(2, 0, 0),
                           Eigen::Vector3f(0, 3, 0)};
  const Eigen::Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const Uvs all_the_same = {Eigen::Vector2f(0.5F, 0.5F), Eigen::Vector2f(0.5F, 0.5F),
                            Eigen::Vector2f(0.5F, 0.5F)};
  const Uvs on_a_line = {Eigen::Vector2f(0, 0), Eigen::Vector2f(0.25F, 0.25F),
                         Eigen::Vector2f(0.5F, 0.5F)};
  for (const Uvs& uv : {all_the_same, on_a_line}) {
    const FaceTangent face = face_tangent(corners, uv);
    EXPECT_NEAR(face.tangent.norm(), 1, 1e-6);
    EXPECT_NEAR(face.tangent.dot(normal), 0, 1e-5);
    EXPECT_EQ(face.handedness, 1);
  }
  const Corners a_point = {corners[0], corners[0], corners[0]};
  const FaceTangent nowhere = face_tangent(a_point, on_a_line);
  EXPECT_NEAR(nowhere.tangent.norm(), 1, 1e-6);
}

TEST(stage07_face_tangent, size_does_not_matter) {
  const Uvs uv = {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 0), Eigen::Vector2f(0, 1)};
  const Corners corners = {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 0, 0),
                           Eigen::Vector3f(0, 1, 0)};
  for (const float size : {1e-38F, 1e-20F, 1.0F, 1e20F, 1e38F}) {
    Corners scaled = corners;
    for (auto& corner : scaled) corner *= size;
    EXPECT_EQ(face_tangent(scaled, uv).tangent, Eigen::Vector3f::UnitX()) << size;
  }
}

}  // namespace
}  // namespace rasterlab

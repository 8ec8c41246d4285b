#include "common/projection/normal_matrix.h"

#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

#include "tests/stage04/random_values.h"

#include <cmath>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

Eigen::Matrix4f with_block(const Eigen::Matrix3f& block) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topLeftCorner<3, 3>() = block;
  return matrix;
}

Vector moved(const Eigen::Matrix4f& model_view, const Vector& normal) {
  return transform_normal(normal_matrix(model_view), normal);
}

TEST(stage04_normal_matrix, rotations_turn_normals_like_anything_else) {
  const Eigen::Matrix4f turn = rotation(90, {0, 0, 1});
  EXPECT_LT((moved(turn, {1, 0, 0}) - Vector(0, 1, 0)).norm(), 1e-6F);
}

TEST(stage04_normal_matrix, translations_do_not_matter) {
  EXPECT_LT(
      (moved(translation({100, -50, 3}), Vector(0.6F, 0.8F, 0)) - Vector(0.6F, 0.8F, 0)).norm(),
      1e-6F)
      << "a normal is a direction: w = 0";
}

TEST(stage04_normal_matrix, pressing_a_ball_flat_turns_its_normals_toward_the_axis) {
  const Vector slanted = Vector(1, 1, 0).normalized();
  const Vector normal = moved(scaling({1, 0.25F, 1}), slanted);
  EXPECT_LT((normal - Vector(0.25F, 1, 0).normalized()).norm(), 1e-6F)
      << "moved like a point it would lean to x";
}

TEST(stage04_normal_matrix, stays_at_a_right_angle_to_the_surface) {
  RandomValues random(410);
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Matrix3f block = random.matrix(2);
    const Vector a = random.direction();
    const Vector b = random.direction();
    if (std::abs(block.determinant()) < 0.05F || a.cross(b).norm() < 0.1F) continue;
    const Vector normal = moved(with_block(block), a.cross(b).normalized());
    ASSERT_NEAR(normal.norm(), 1, 1e-6);
    ASSERT_NEAR(normal.dot((block * a).normalized()), 0, 1e-5);
    ASSERT_NEAR(normal.dot((block * b).normalized()), 0, 1e-5);
  }
}

TEST(stage04_normal_matrix, is_the_inverse_transpose_of_even_a_mirror) {
  RandomValues random(4101);
  int mirrors = 0;
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Matrix3f block = random.matrix(2);
    if (std::abs(block.determinant()) < 0.05F) continue;
    mirrors += block.determinant() < 0 ? 1 : 0;
    const Vector normal = random.direction();
    const Eigen::Vector3d expected =
        (block.cast<double>().inverse().transpose() * normal.cast<double>()).normalized();
    ASSERT_LT((moved(with_block(block), normal).cast<double>() - expected).norm(), 1e-5)
        << "det " << block.determinant();
  }
  EXPECT_GT(mirrors, 1000);
}

TEST(stage04_normal_matrix, what_pointed_outside_still_does_in_a_mirror) {
  // The right side of a box is its left side in the mirror x → −x, and faces left.
  EXPECT_EQ(moved(scaling({-1, 1, 1}), Vector(1, 0, 0)), Vector(-1, 0, 0));
  EXPECT_EQ(moved(scaling({-1, 1, 1}), Vector(0, 1, 0)), Vector(0, 1, 0));
}

TEST(stage04_normal_matrix, pressed_into_a_plane_it_is_that_planes_normal) {
  const Vector normal = moved(scaling({1, 0, 1}), Vector(1, 1, 1).normalized());
  EXPECT_EQ(normal.cwiseAbs(), Vector(0, 1, 0)) << "there is no inverse; cofactors need none";
  EXPECT_TRUE(moved(scaling({0, 0, 1}), Vector(1, 1, 1).normalized()).isZero())
      << "a line has no one normal";
  EXPECT_TRUE(normal_matrix(scaling({0, 0, 0})).isZero());
}

TEST(stage04_normal_matrix, any_scale_from_tiny_to_huge) {
  for (const float scale : {1e-30F, 1e-18F, 1e18F, 1e30F}) {
    const Vector normal = moved(scaling({scale, scale, scale}), Vector(0.6F, 0, 0.8F));
    EXPECT_LT((normal - Vector(0.6F, 0, 0.8F)).norm(), 1e-6F) << scale;
  }
}

}  // namespace
}  // namespace rasterlab

#include "common/projection/transforms_2d.h"

#include <limits>
#include <numbers>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float quarter = std::numbers::pi_v<float> / 2;

testing::AssertionResult is_at(const Eigen::Vector3f& homogeneous, float x, float y) {
  const Eigen::Vector2f point = to_plane(homogeneous);
  if ((point - Eigen::Vector2f(x, y)).norm() < 1e-5F) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "lands on (" << point.transpose() << "), should on (" << x << ", " << y << ")";
}

TEST(stage04_transforms_2d, scale_multiplies_each_coordinate_by_its_own_factor) {
  EXPECT_TRUE(is_at(scale_2d(2, 3) * point_2d(5, 7), 10, 21));
  EXPECT_TRUE(is_at(scale_2d(-1, 1) * point_2d(5, 7), -5, 7)) << "a mirror is a scale, too";
}

TEST(stage04_transforms_2d, a_factor_of_0_presses_the_plane_onto_a_line) {
  EXPECT_TRUE(is_at(scale_2d(0, 1) * point_2d(5, 7), 0, 7));
  EXPECT_TRUE(is_at(scale_2d(0, 0) * point_2d(5, 7), 0, 0));
}

TEST(stage04_transforms_2d, shear_adds_the_other_coordinate) {
  EXPECT_TRUE(is_at(shear_2d(0.5F, 0) * point_2d(1, 4), 3, 4)) << "x grows with y";
  EXPECT_TRUE(is_at(shear_2d(0, 0.5F) * point_2d(4, 1), 4, 3)) << "y grows with x";
}

TEST(stage04_transforms_2d, rotation_is_counter_clockwise) {
  EXPECT_TRUE(is_at(rotate_2d(quarter) * point_2d(1, 0), 0, 1))
      << "a quarter turn takes x to y when y is up";
  EXPECT_TRUE(is_at(rotate_2d(quarter) * point_2d(0, 1), -1, 0));
  EXPECT_TRUE(is_at(rotate_2d(-7 * quarter) * point_2d(1, 0), 0, 1)) << "beyond a whole turn";
}

TEST(stage04_transforms_2d, translation_moves_points_but_not_directions) {
  EXPECT_TRUE(is_at(translate_2d(3, -2) * point_2d(1, 1), 4, -1));
  EXPECT_EQ(translate_2d(3, -2) * direction_2d(1, 1), direction_2d(1, 1))
      << "a direction (w = 0) has no place to move from";
}

TEST(stage04_transforms_2d, the_matrix_on_the_right_acts_first) {
  const Eigen::Matrix3f turn = rotate_2d(quarter);
  const Eigen::Matrix3f move = translate_2d(2, 0);
  EXPECT_TRUE(is_at(turn * move * point_2d(1, 0), 0, 3));
  EXPECT_TRUE(is_at(move * turn * point_2d(1, 0), 2, 1));
}

TEST(stage04_transforms_2d, turning_about_a_point_leaves_that_point_where_it_is) {
  const Eigen::Vector2f center(5, -3);
  for (const float angle : {0.3F, quarter, 4.0F}) {
    EXPECT_TRUE(is_at(rotate_about_2d(center, angle) * point_2d(5, -3), 5, -3));
  }
  EXPECT_TRUE(is_at(rotate_about_2d(center, quarter) * point_2d(6, -3), 5, -2))
      << "what was on the right of the centre is above it after a quarter turn";
}

TEST(stage04_transforms_2d, any_multiple_is_the_same_point) {
  for (const float w : {1.0F, 0.25F, -3.0F, 1e-30F}) {
    EXPECT_TRUE(is_at({2 * w, -5 * w, w}, 2, -5)) << "w = " << w;
  }
}

TEST(stage04_transforms_2d, a_point_at_infinity_is_the_limit_of_its_direction) {
  EXPECT_EQ(to_plane({1, -2, 0}), Eigen::Vector2f(infinity, -infinity));
  EXPECT_EQ(to_plane({0, 2, 0}), Eigen::Vector2f(0, infinity))
      << "0 / 0 is not a number, but the limit of 0 / w is 0";
  EXPECT_EQ(to_plane({-3, 0, -0.0F}), Eigen::Vector2f(-infinity, 0));
}

TEST(stage04_transforms_2d, a_last_row_other_than_0_0_1_brings_a_point_at_infinity_near) {
  Eigen::Matrix3f projective = Eigen::Matrix3f::Identity();
  projective(2, 1) = 0.5F;
  EXPECT_TRUE(is_at(projective * direction_2d(0, 1), 0, 2));
}

}  // namespace
}  // namespace rasterlab

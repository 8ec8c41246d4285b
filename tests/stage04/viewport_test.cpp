#include "common/projection/viewport.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

Eigen::Vector3f moved(const Eigen::Matrix4f& matrix, float x, float y, float z) {
  return (matrix * Eigen::Vector4f(x, y, z, 1)).hnormalized();
}

TEST(stage04_viewport, translation_moves_points_but_not_directions) {
  EXPECT_EQ(moved(translation({1, 2, 3}), 10, 20, 30), Eigen::Vector3f(11, 22, 33));
  EXPECT_EQ((translation({1, 2, 3}) * Eigen::Vector4f(10, 20, 30, 0)),
            Eigen::Vector4f(10, 20, 30, 0));
}

TEST(stage04_viewport, scaling_multiplies_each_coordinate) {
  EXPECT_EQ(moved(scaling({2, 3, 4}), 10, 20, 30), Eigen::Vector3f(20, 60, 120));
}

TEST(stage04_viewport, corners_of_ndc_are_corners_of_a_picture_that_is_not_square) {
  const Eigen::Matrix4f matrix = viewport(0, 0, 640, 480);
  EXPECT_EQ(moved(matrix, -1, 1, 0), Eigen::Vector3f(0, 0, 0)) << "top left: NDC y is up";
  EXPECT_EQ(moved(matrix, 1, 1, 0), Eigen::Vector3f(640, 0, 0)) << "top right";
  EXPECT_EQ(moved(matrix, -1, -1, 0), Eigen::Vector3f(0, 480, 0)) << "bottom left";
  EXPECT_EQ(moved(matrix, 1, -1, 0), Eigen::Vector3f(640, 480, 0)) << "bottom right";
}

TEST(stage04_viewport, the_middle_is_the_middle_and_pixel_centres_are_halves) {
  EXPECT_EQ(moved(viewport(0, 0, 4, 2), 0, 0, 0), Eigen::Vector3f(2, 1, 0));
  EXPECT_EQ(moved(viewport(0, 0, 4, 2), -0.75F, 0.5F, 0), Eigen::Vector3f(0.5F, 0.5F, 0))
      << "the centre of pixel (0, 0)";
}

TEST(stage04_viewport, a_rectangle_within_the_window) {
  const Eigen::Matrix4f matrix = viewport(100, 25, 600, 150);
  EXPECT_EQ(moved(matrix, -1, 1, 0), Eigen::Vector3f(100, 25, 0));
  EXPECT_EQ(moved(matrix, 1, -1, 0), Eigen::Vector3f(700, 175, 0));
}

TEST(stage04_viewport, a_rectangle_without_width_is_a_line) {
  const Eigen::Matrix4f matrix = viewport(5, 0, 0, 10);
  EXPECT_EQ(moved(matrix, -1, 1, 0), Eigen::Vector3f(5, 0, 0));
  EXPECT_EQ(moved(matrix, 1, -1, 0), Eigen::Vector3f(5, 10, 0));
}

TEST(stage04_viewport, depth_stays_as_it_is) {
  for (const float z : {-1.0F, 0.25F, 1.0F}) {
    EXPECT_EQ(moved(viewport(3, 4, 50, 60), 0.5F, 0.5F, z).z(), z);
  }
}

}  // namespace
}  // namespace rasterlab

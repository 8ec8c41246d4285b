#include "common/projection/perspective.h"

#include "common/image/check.h"
#include "common/projection/eye.h"
#include "common/projection/orthographic.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Eigen::Vector4f clip(const Eigen::Matrix4f& matrix, double x, double y, double z) {
  return matrix * Eigen::Vector4d(x, y, z, 1).cast<float>();
}

TEST(stage04_perspective, near_and_far_planes_land_on_minus_1_and_1) {
  const Eigen::Matrix4f matrix = perspective(60, 1, 0.1F, 20);
  EXPECT_NEAR(clip(matrix, 0, 0, -0.1).hnormalized().z(), -1, 1e-6);
  EXPECT_NEAR(clip(matrix, 0, 0, -20).hnormalized().z(), 1, 1e-6);
}

TEST(stage04_perspective, w_is_the_distance_along_the_view_axis) {
  EXPECT_FLOAT_EQ(clip(perspective(60, 1, 0.1F, 20), 3, -2, -7).w(), 7);
}

TEST(stage04_perspective, the_field_of_view_is_from_bottom_to_top) {
  for (const double fovy : {1.0, 40.0, 60.0, 90.0, 170.0}) {
    const double half = std::tan(fovy * std::numbers::pi / 360);
    const Eigen::Matrix4f matrix = perspective(static_cast<float>(fovy), 1.5F, 0.1F, 20);
    EXPECT_NEAR(clip(matrix, 0, 3 * half, -3).hnormalized().y(), 1, 1e-5) << fovy << " degrees";
    EXPECT_NEAR(clip(matrix, 3 * half * 1.5, 0, -3).hnormalized().x(), 1, 1e-5)
        << "the picture is 1.5 times as wide as high; " << fovy << " degrees";
  }
}

TEST(stage04_perspective, the_far_plane_may_be_infinite) {
  const Eigen::Matrix4f matrix = perspective(60, 1, 0.1F, infinity);
  EXPECT_TRUE(matrix.allFinite());
  EXPECT_NEAR(clip(matrix, 0, 0, -0.1).hnormalized().z(), -1, 1e-6);
  EXPECT_NEAR(clip(matrix, 0, 0, -1e6).hnormalized().z(), 1, 1e-6);
  EXPECT_LE(clip(matrix, 0, 0, -1e30).hnormalized().z(), 1);
  EXPECT_TRUE(matrix.isApprox(perspective(60, 1, 0.1F, 1e30F), 1e-6F))
      << "it is what a very far plane comes to";
}

TEST(stage04_perspective, impossible_cameras_are_refused) {
  for (const float fovy : {0.0F, 180.0F, -60.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(perspective(fovy, 1, 0.1F, 20), CheckError) << fovy;
  }
  EXPECT_THROW(perspective(60, 0, 0.1F, 20), CheckError);
  EXPECT_THROW(perspective(60, 1, 0, 20), CheckError);
  EXPECT_THROW(perspective(60, 1, 20, 20), CheckError);
  EXPECT_THROW(perspective(60, 1, infinity, infinity), CheckError);
}

TEST(stage04_orthographic, a_box_becomes_the_cube_and_w_is_1) {
  const Eigen::Matrix4f matrix = orthographic(4, 1.5F, 1, 9);
  EXPECT_EQ(clip(matrix, 3, 2, -1), Eigen::Vector4f(1, 1, -1, 1));
  EXPECT_EQ(clip(matrix, -3, -2, -9), Eigen::Vector4f(-1, -1, 1, 1));
  EXPECT_EQ(clip(orthographic(4, 1, -5, 5), 0, 0, 0), Eigen::Vector4f(0, 0, 0, 1))
      << "the eye may stand in the middle of what is seen";
}

TEST(stage04_orthographic, impossible_cameras_are_refused) {
  EXPECT_THROW(orthographic(0, 1, 1, 9), CheckError);
  EXPECT_THROW(orthographic(4, -1, 1, 9), CheckError);
  EXPECT_THROW(orthographic(4, 1, 9, 9), CheckError);
  EXPECT_THROW(orthographic(4, 1, 1, infinity), CheckError);
}

TEST(stage04_eye, a_perspective_is_seen_from_the_camera_and_an_orthographic_from_far_away) {
  Transforms transforms;
  transforms.view = Eigen::Matrix4f::Identity();
  transforms.view.topRightCorner<3, 1>() = Eigen::Vector3f(-1, -2, -3);
  transforms.projection = perspective(60, 1, 0.1F, infinity);
  EXPECT_TRUE(eye_of(transforms).isApprox(Eigen::Vector4f(1, 2, 3, 1), 1e-5F));
  transforms.projection = orthographic(4, 1, 1, 9);
  EXPECT_TRUE(eye_of(transforms).isApprox(Eigen::Vector4f(0, 0, 1, 0), 1e-5F));
}

}  // namespace
}  // namespace rasterlab

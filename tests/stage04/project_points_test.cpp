#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/pinhole.h"
#include "common/projection/vertex_stage.h"

#include "tests/stage04/random_values.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

Vector project(const Vector& point, const Eigen::Matrix4f& camera, const Eigen::Matrix3f& k) {
  return project_points({point}, camera, k).at(0);
}

TEST(stage04_project_points, the_camera_has_x_right_y_down_z_forward) {
  // In front of the origin, looking along −z of a world whose y is up.
  const Eigen::Matrix4f camera = world_to_camera({0, 0, 5}, {0, 0, 0}, {0, -1, 0});
  const auto seen = [&](const Vector& point) -> Vector {
    return (camera * point.homogeneous()).head<3>();
  };
  EXPECT_LT((seen({0, 0, 0}) - Vector(0, 0, 5)).norm(), 1e-6F) << "ahead is +z";
  EXPECT_LT((seen({1, 0, 0}) - Vector(1, 0, 5)).norm(), 1e-6F) << "right is +x";
  EXPECT_LT((seen({0, 1, 0}) - Vector(0, -1, 5)).norm(), 1e-6F) << "up in the world is −y";
}

TEST(stage04_project_points, up_is_where_image_y_goes) {
  const Eigen::Matrix4f camera = world_to_camera({1, 2, 3}, {0.5F, 0, -1}, {0.3F, -1, 0.2F});
  const Vector along = camera.topLeftCorner<3, 3>() * Vector(0.3F, -1, 0.2F);
  EXPECT_GT(along.y(), 0);
  EXPECT_NEAR(along.x(), 0, 1e-6);
  EXPECT_NEAR((camera.topLeftCorner<3, 3>().determinant()), 1, 1e-6) << "no mirror";
  EXPECT_LT((camera * Eigen::Vector4f(1, 2, 3, 1)).head<3>().norm(), 1e-6F)
      << "the eye is the origin: t = −R·eye";
}

TEST(stage04_project_points, the_axis_is_in_the_middle_and_the_focal_length_in_pixels) {
  const Eigen::Matrix3f k = calibration(100, 320, 200);
  Eigen::Matrix3f expected;
  expected << 100, 0, 160, 0, 100, 100, 0, 0, 1;
  EXPECT_EQ(k, expected);
  const Eigen::Matrix4f camera = Eigen::Matrix4f::Identity();
  EXPECT_EQ(project({0, 0, 4}, camera, k), Vector(160, 100, 4));
  EXPECT_EQ(project({1, -2, 4}, camera, k), Vector(185, 50, 4)) << "depth is kept";
}

TEST(stage04_project_points, points_keep_their_order) {
  const std::vector<Vector> points = project_points(
      {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, Eigen::Matrix4f::Identity(), calibration(10, 20, 20));
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1], Vector(20, 10, 1));
  EXPECT_EQ(points[2], Vector(10, 20, 1));
  EXPECT_TRUE(project_points({}, Eigen::Matrix4f::Identity(), calibration(10, 20, 20)).empty());
}

TEST(stage04_project_points, what_is_not_in_front_has_no_place_in_the_picture) {
  const Eigen::Matrix3f k = calibration(100, 320, 200);
  for (const float depth : {0.0F, -0.5F, -4.0F}) {
    const Vector point = project({1, 1, depth}, Eigen::Matrix4f::Identity(), k);
    EXPECT_TRUE(std::isnan(point.x()) && std::isnan(point.y())) << depth;
    EXPECT_EQ(point.z(), depth);
  }
}

TEST(stage04_project_points, is_where_perspective_and_viewport_put_the_point) {
  RandomValues random(406);
  for (int i = 0; i < 1000; ++i) {
    const int width = 100 + random.index(900);
    const int height = 100 + random.index(900);
    const float focal_length = random.number(50, 2000);
    const Vector eye = random.vector(3);
    const Vector center = random.vector(3);
    const Vector up = random.direction();
    const Vector point = center + random.vector(0.5F);
    const Vector pinhole =
        project(point, world_to_camera(eye, center, -up), calibration(focal_length, width, height));
    if (!(pinhole.z() > 0.1F)) continue;
    const double half_angle = std::atan(height / 2.0 / static_cast<double>(focal_length));
    const float fovy = static_cast<float>(half_angle * 360 / std::numbers::pi);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const Eigen::Matrix4f matrix = perspective(fovy, aspect, 0.01F, 100) * look_at(eye, center, up);
    const Eigen::Vector4f clip = to_clip(matrix, point);
    const Eigen::Vector2f window = to_window(clip, width, height).position;
    ASSERT_LT((window - pinhole.head<2>()).norm(), 1e-4F * std::max(window.norm(), 1000.0F));
    ASSERT_NEAR(clip.w(), pinhole.z(), 1e-5F * pinhole.z());
  }
}

}  // namespace
}  // namespace rasterlab

#include "common/projection/central_projection.h"

#include "common/image/check.h"

#include <limits>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

Eigen::Vector3f projected(float distance, float x, float y, float z) {
  return (central_projection(distance) * Eigen::Vector4f(x, y, z, 1)).hnormalized();
}

TEST(stage04_central_projection, what_is_in_the_plane_z_0_stays) {
  EXPECT_EQ(projected(2, 0.5F, -0.25F, 0), Eigen::Vector3f(0.5F, -0.25F, 0));
}

TEST(stage04_central_projection, lines_of_sight_go_through_the_eye) {
  // From the eye (0, 0, 2) through (x, y, z), the plane z = 0 is met at 2 / (2 − z) times (x, y).
  EXPECT_EQ(projected(2, 0.5F, -0.25F, 1), Eigen::Vector3f(1, -0.5F, 2));
  EXPECT_EQ(projected(2, 0.5F, -0.25F, -2), Eigen::Vector3f(0.25F, -0.125F, -1));
}

TEST(stage04_central_projection, nearer_is_still_larger_z) {
  EXPECT_GT(projected(2, 0, 0, 1).z(), projected(2, 0, 0, 0.5F).z());
  EXPECT_GT(projected(2, 0, 0, -1).z(), projected(2, 0, 0, -5).z());
}

TEST(stage04_central_projection, what_is_not_in_front_of_the_eye_has_w_not_above_0) {
  const Eigen::Matrix4f matrix = central_projection(2);
  EXPECT_EQ((matrix * Eigen::Vector4f(0, 0, 2, 1)).w(), 0) << "the eye itself";
  EXPECT_LT((matrix * Eigen::Vector4f(0, 0, 3, 1)).w(), 0) << "behind it";
}

TEST(stage04_central_projection, from_infinitely_far_it_is_orthographic) {
  EXPECT_EQ(central_projection(std::numeric_limits<float>::infinity()),
            Eigen::Matrix4f::Identity());
}

TEST(stage04_central_projection, distances_that_are_none_are_refused) {
  for (const float distance : {0.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(central_projection(distance), CheckError) << distance;
  }
}

}  // namespace
}  // namespace rasterlab

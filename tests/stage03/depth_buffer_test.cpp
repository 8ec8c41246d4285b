#include "common/zbuffer/depth_buffer.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

TEST(stage03_depth_buffer, starts_at_the_farthest) {
  const DepthBuffer depth(3, 2);
  for (const float z : depth.depths().pixels())
    EXPECT_EQ(z, 1.0F) << "a new buffer holds the far plane everywhere";
  EXPECT_TRUE(depth.test(2, 1, 0.999F)) << "what is nearer than the far plane is seen";
  EXPECT_FALSE(depth.test(2, 1, 1.5F)) << "what is behind the far plane is not";
}

TEST(stage03_depth_buffer, nearer_is_less) {
  DepthBuffer depth(3, 2);
  depth.write(1, 1, 0.25F);
  EXPECT_TRUE(depth.test(1, 1, 0.2F)) << "z = 0.2 is in front of 0.25: smaller is nearer";
  EXPECT_FALSE(depth.test(1, 1, 0.3F)) << "z = 0.3 is behind 0.25";
}

TEST(stage03_depth_buffer, of_equals_the_earlier_stays) {
  DepthBuffer depth(3, 2);
  depth.write(1, 1, 0.25F);
  EXPECT_FALSE(depth.test(1, 1, 0.25F))
      << "the second of two at the same depth must not be seen: compare with <, not <=";
}

TEST(stage03_depth_buffer, not_a_number_is_not_seen) {
  const DepthBuffer depth(3, 2);
  EXPECT_FALSE(depth.test(0, 0, not_a_number));
}

TEST(stage03_depth_buffer, test_changes_nothing) {
  const DepthBuffer fresh(3, 2);
  DepthBuffer depth(3, 2);
  depth.test(1, 1, -1);
  EXPECT_EQ(depth.depths(), fresh.depths()) << "test() only answers; write() stores";
}

TEST(stage03_depth_buffer, write_stores_one_pixel) {
  DepthBuffer depth(3, 2);
  depth.write(2, 0, -0.5F);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      EXPECT_EQ(depth.depths()(x, y), x == 2 && y == 0 ? -0.5F : 1.0F)
          << "pixel (" << x << ", " << y << ")";
    }
  }
}

TEST(stage03_depth_buffer, clear_forgets) {
  DepthBuffer depth(3, 2);
  depth.write(2, 0, -0.5F);
  depth.clear();
  EXPECT_EQ(depth.depths(), DepthBuffer(3, 2).depths());
}

TEST(stage03_depth_buffer, outside_throws) {
  DepthBuffer depth(3, 2);
  EXPECT_THROW(depth.test(3, 0, 0), CheckError);
  EXPECT_THROW(depth.write(0, -1, 0), CheckError);
}

}  // namespace
}  // namespace rasterlab

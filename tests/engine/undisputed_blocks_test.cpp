// What a block knows of triangles that don't compete for its pixels.
#include "common/engine/undisputed_blocks.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr BlockMask row(int y) {
  return BlockMask{0xFF} << (8 * y);
}
constexpr BlockMask column(int x) {
  return BlockMask{0x0101010101010101} << x;
}

class engine_undisputed_blocks : public testing::Test {
 protected:
  engine_undisputed_blocks() { blocks_.begin(1); }

  bool add(BlockMask pixels, DepthBounds<float> depths, std::int32_t plane) {
    return blocks_.add(0, pixels, depths, plane, far_);
  }
  /// Which plane each part shows, and where.
  std::vector<std::pair<std::int32_t, BlockMask>> parts() const {
    std::vector<std::pair<std::int32_t, BlockMask>> parts;
    for (const UndisputedBlocks::Part& part : blocks_.parts(0)) {
      parts.emplace_back(part.plane, part.pixels);
    }
    return parts;
  }

  UndisputedBlocks blocks_;
  float far_ = 0;
};

TEST_F(engine_undisputed_blocks, nearer_ones_take_pixels_and_farther_ones_get_the_rest) {
  EXPECT_TRUE(add(row(0) | row(1), {0.4F, 0.5F}, 0));
  EXPECT_TRUE(add(row(1), {0.6F, 0.7F}, 1));
  EXPECT_TRUE(add(column(0), {0.2F, 0.3F}, 2));
  const BlockMask rest = column(0) & ~(row(0) | row(1));
  EXPECT_THAT(parts(), testing::ElementsAre(testing::Pair(0, row(0)), testing::Pair(1, row(1)),
                                            testing::Pair(2, rest)));
  EXPECT_EQ(far_, 0);
  EXPECT_TRUE(add(all_64, {0.1F, 0.15F}, 3));
  EXPECT_EQ(far_, 0.1F);
}

TEST_F(engine_undisputed_blocks, draw_nothing_where_depths_may_cross) {
  EXPECT_TRUE(add(row(0), {0.4F, 0.6F}, 0));
  EXPECT_FALSE(add(row(0) | row(1), {0.5F, 0.7F}, 1));
  EXPECT_THAT(parts(), testing::ElementsAre(testing::Pair(0, row(0))));
}

TEST_F(engine_undisputed_blocks, draw_nothing_where_there_is_no_room) {
  for (int y = 0; y < 8; ++y) EXPECT_TRUE(add(row(y), {0.4F, 0.5F}, y));
  const auto full = parts();
  EXPECT_FALSE(add(column(0), {0.6F, 0.7F}, 8));
  EXPECT_EQ(parts(), full);
  EXPECT_TRUE(add(column(0), {0.2F, 0.3F}, 8)) << "all of it is hidden";
  EXPECT_EQ(parts(), full);
}

}  // namespace
}  // namespace rasterlab

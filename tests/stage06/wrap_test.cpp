#include "common/texture/wrap.h"

#include "tests/stage06/quad.h"
#include "tests/support/toy_lanes.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
const float after_1 = std::nextafter(1.0F, 2.0F);
const float before_1 = std::nextafter(1.0F, 0.0F);
const float smallest = std::numeric_limits<float>::denorm_min();

struct Case {
  float coordinate;
  float repeat;
  float clamp;
  float mirror;
};

const Case cases[] = {
    {0.0F, 0, 0, 0},
    {-0.0F, 0, 0, 0},
    {0.25F, 0.25F, 0.25F, 0.25F},
    {1.0F, 1, 1, 1},  // the far edge is the texture's own
    {after_1, after_1 - 1, 1, before_1 - (after_1 - 1) / 2},
    {before_1, before_1, before_1, before_1},
    {smallest, smallest, smallest, smallest},
    {-smallest, 1, 0, smallest},
    {-0x1p-24F, before_1, 0, 0x1p-24F},
    {-0.25F, 0.75F, 0, 0.25F},  // rounded down, not truncated
    {-1.0F, 0, 0, 1},
    {-1.75F, 0.25F, 0, 0.25F},
    {1.25F, 0.25F, 1, 0.75F},
    {2.0F, 0, 1, 0},
    {3.0F, 0, 1, 1},
    {2.5F, 0.5F, 1, 0.5F},
    {0x1p24F, 0, 1, 0},
    {0x1p24F - 1, 0, 1, 1},
    {-0x1p24F, 0, 0, 0},
    {0x1p100F, 0, 1, 0},
    {infinity, 0, 1, 0},
    {-infinity, 0, 0, 0},
    {not_a_number, 0, 0, 0},
};

TEST(stage06_wrap_coordinate, special_values) {
  for (const Case& test : cases) {
    EXPECT_EQ(wrap_coordinate(test.coordinate, Wrap::repeat), test.repeat) << test.coordinate;
    EXPECT_EQ(wrap_coordinate(test.coordinate, Wrap::clamp), test.clamp) << test.coordinate;
    const bool inside = test.coordinate >= 0 && test.coordinate <= 1;
    EXPECT_NEAR(wrap_coordinate(test.coordinate, Wrap::mirror), test.mirror, inside ? 0 : 0x1p-24)
        << test.coordinate;
  }
}

TEST(stage06_wrap_coordinate, agrees_with_exact_arithmetic) {
  std::mt19937 random(6);
  for (const float range : {1.0F, 3.0F, 1000.0F, 0x1p24F}) {
    std::uniform_real_distribution<float> coordinates(-range, range);
    for (int i = 0; i < 20000; ++i) {
      const float u = coordinates(random);
      if (u == 1) continue;  // the exception, in special_values
      const Quad exact = u;
      const Quad fraction = exact - quad_floor(exact);
      const Quad in_period = exact - 2 * quad_floor(exact / 2);
      const Quad mirrored = in_period > 1 ? 2 - in_period : in_period;
      EXPECT_LE(difference(wrap_coordinate(u, Wrap::repeat), fraction), 0x1p-25) << u;
      EXPECT_LE(difference(wrap_coordinate(u, Wrap::mirror), mirrored), 0x1p-24) << u;
      EXPECT_EQ(wrap_coordinate(u, Wrap::clamp), u < 0 ? 0 : (u > 1 ? 1 : u));
    }
  }
}

TEST(stage06_wrap_coordinate, lanes_equal_one_float) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
    for (std::size_t first = 0; first + 4 <= std::size(cases); ++first) {
      ToyLanes<4> lanes;
      for (std::size_t i = 0; i < 4; ++i) lanes.lane[i] = cases[first + i].coordinate;
      const ToyLanes<4> wrapped = wrap_coordinate(lanes, wrap);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(wrapped.lane[i], wrap_coordinate(lanes.lane[i], wrap));
      }
    }
  }
}

TEST(stage06_wrap_coordinate, neighbours_stay_inside) {
  for (const float size : {1.0F, 2.0F, 5.0F}) {
    EXPECT_EQ(wrap_neighbor(-1.0F, size, Wrap::repeat), size - 1);
    EXPECT_EQ(wrap_neighbor(size, size, Wrap::repeat), 0);
    EXPECT_EQ(wrap_neighbor(0.0F, size, Wrap::repeat), 0);
    EXPECT_EQ(wrap_neighbor(size - 1, size, Wrap::repeat), size - 1);
    for (const Wrap wrap : {Wrap::clamp, Wrap::mirror}) {
      EXPECT_EQ(wrap_neighbor(-1.0F, size, wrap), 0);
      EXPECT_EQ(wrap_neighbor(size, size, wrap), size - 1);
    }
  }
}

}  // namespace
}  // namespace rasterlab

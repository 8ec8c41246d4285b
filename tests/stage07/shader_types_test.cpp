#include "common/mesh/shader_types.h"

#include "tests/support/toy_lanes.h"

#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace shader_types_test {  // not unnamed: templates of the library have these as members

struct Opaque {
  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
    Vector2<Number> uv;
    Number weight;
  };
  Varyings<float> vertex(const Mesh&, std::uint32_t, int) const { return {}; }
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return point.value.normal;
  }
};

struct PlainScalarThatDiscards {
  template <class Number>
  struct Varyings {};
  Varyings<float> vertex(const Mesh&, std::uint32_t, int) const { return {}; }
  Fragment<float> fragment(const SurfacePoint<Varyings, float>&) const { return {}; }
};

struct NoShader {
  template <class Number>
  struct Varyings {};
};

}  // namespace shader_types_test

namespace {

using shader_types_test::NoShader;
using shader_types_test::Opaque;
using shader_types_test::PlainScalarThatDiscards;

static_assert(ShaderType<Opaque> && !may_discard<Opaque>);
static_assert(ShaderType<PlainScalarThatDiscards> && may_discard<PlainScalarThatDiscards>);
static_assert(!ShaderType<NoShader>);
static_assert(ShadesNumbers<Opaque, ToyLanes<4>>);
static_assert(!ShadesNumbers<PlainScalarThatDiscards, ToyLanes<4>>);
static_assert(number_count<Opaque::Varyings>() == 6);
static_assert(number_count<PlainScalarThatDiscards::Varyings>() == 0);

std::array<Opaque::Varyings<float>, 3> random_corners(std::mt19937& random) {
  std::uniform_real_distribution<float> value(-10, 10);
  std::array<Opaque::Varyings<float>, 3> corners;
  for (auto& corner : corners) {
    for (int i = 0; i < 6; ++i) numbers(corner)[i] = value(random);
  }
  return corners;
}

TEST(stage07_shader_types, a_varyings_is_the_array_of_its_numbers) {
  Opaque::Varyings<float> varyings{{1, 2, 3}, {4, 5}, 6};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(numbers(varyings)[i], static_cast<float>(i + 1));
  numbers(varyings)[4] = 50;
  EXPECT_EQ(varyings.uv.y(), 50);
}

TEST(stage07_interpolate, corners_have_their_own_values_and_equal_values_stay) {
  std::mt19937 random(1);
  const auto corners = random_corners(random);
  const auto first = interpolate(corners, CornerWeights<float>{0, 0});
  for (int i = 0; i < 6; ++i) EXPECT_EQ(numbers(first)[i], numbers(corners[0])[i]);
  std::uniform_real_distribution<float> part(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const auto same = interpolate(std::array{corners[1], corners[1], corners[1]},
                                  CornerWeights<float>{part(random), part(random)});
    for (int k = 0; k < 6; ++k) EXPECT_EQ(numbers(same)[k], numbers(corners[1])[k]);
  }
}

TEST(stage07_interpolate, mixes_and_derives_as_the_formula_says) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> part(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const auto corners = random_corners(random);
    const CornerWeights<float> weights{part(random) / 2, part(random) / 2};
    const auto mixed = interpolate(corners, weights);
    const auto derived = interpolate_differences(corners, weights);
    for (int k = 0; k < 6; ++k) {
      const double a0 = numbers(corners[0])[k];
      const double differences =
          weights.b1 * (numbers(corners[1])[k] - a0) + weights.b2 * (numbers(corners[2])[k] - a0);
      EXPECT_NEAR(numbers(derived)[k], differences, 4e-6);
      EXPECT_NEAR(numbers(mixed)[k], a0 + differences, 4e-6);
    }
  }
}

TEST(stage07_interpolate, lanes_equal_one_float) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> part(0, 1);
  for (int i = 0; i < 300; ++i) {
    const auto corners = random_corners(random);
    CornerWeights<ToyLanes<4>> wide;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      wide.b1.lane[lane] = part(random);
      wide.b2.lane[lane] = part(random);
    }
    const auto mixed = interpolate(corners, wide);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto one =
          interpolate(corners, CornerWeights<float>{wide.b1.lane[lane], wide.b2.lane[lane]});
      for (int k = 0; k < 6; ++k) EXPECT_EQ(numbers(mixed)[k].lane[lane], numbers(one)[k]);
    }
  }
}

}  // namespace
}  // namespace rasterlab

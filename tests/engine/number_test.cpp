// What the engine's wide numbers compute is, in every lane and on every instruction set, what one
// float does.
#include "common/image/number.h"

#include "common/engine/compiled_simd_targets.h"
#include "common/image/pixel.h"

#include "tests/engine/wide_numbers.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {

#define RASTERLAB_DECLARE_WIDE_NUMBERS(simd) \
  namespace simd_##simd {                    \
    WideNumbers wide_numbers();              \
  }
RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_DECLARE_WIDE_NUMBERS)

WideNumbers wide_numbers(SimdTarget target) {
#define RASTERLAB_TAKE_WIDE_NUMBERS(simd) \
  if (target == SimdTarget::simd) return simd_##simd::wide_numbers();
  RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_TAKE_WIDE_NUMBERS)
  return {};
}

namespace {

__extension__ using Exact = __float128;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Sums that are hard to round.
class HardSums {
 public:
  ThreeNumbers next() {
    switch (random_() % 6) {
      case 0:
        return {any(), any(), any()};
      case 1:  // What is left when nearly everything cancels.
        return with_sum([](float product, float) { return -product; });
      case 2:  // Half of the last place, and a little more or less.
        return beside_half(std::ldexp(mantissa(), exponent(-100, 100)));
      case 3:  // Half of the smallest denormal's place, and a little more or less.
        return beside_half(static_cast<float>(random_() % 64) * smallest);
      case 4:  // At the end of what there is.
        return beside_half(largest - std::ldexp(static_cast<float>(random_() % 3), 104));
      default:  // Somewhat beside half of some place.
        return with_sum([this](float product, float unit) {
          return std::ldexp(mantissa(), exponent(-2, 26)) * unit - product;
        });
    }
  }

 private:
  float any() { return std::bit_cast<float>(static_cast<std::uint32_t>(random_())); }
  int exponent(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low));
  }
  /// Of either sign, from 1 to 2, often with few digits.
  float mantissa() {
    const auto digits = static_cast<std::uint32_t>(random_()) & (0x7FFFFFU << random_() % 24U);
    const float value = std::bit_cast<float>(0x3F800000U | (digits & 0x7FFFFFU));
    return random_() % 2 == 0 ? value : -value;
  }
  template <class Sum>
  ThreeNumbers with_sum(const Sum& sum) {
    const float a = std::ldexp(mantissa(), exponent(-60, 60));
    const float b = std::ldexp(mantissa(), exponent(-60, 60));
    const float product = a * b;
    return {a, b, sum(product, std::ldexp(1.0F, std::ilogb(product) - 23))};
  }
  /// c plus nearly half of what lies between it and the next number: too near for a double's
  /// digits.
  ThreeNumbers beside_half(float c) {
    const float next = std::nextafter(c, random_() % 2 == 0 ? 2 * c : 0);
    int scale = 0;
    std::frexp(static_cast<double>(next) - static_cast<double>(c), &scale);
    const auto steps = static_cast<float>(random_() % 8);
    const float more = 1 + steps * 0x1p-23F;
    const float less = 1 - (random_() % 2 == 0 ? steps : 1) * 0x1p-23F;
    const int scale_of_a = std::clamp(scale, -100, 100);
    const float sign = next > c ? 1.0F : -1.0F;
    return {sign * std::ldexp(more, scale_of_a), std::ldexp(less, scale - 2 - scale_of_a), c};
  }

  std::mt19937 random_{7};
};

std::vector<ThreeNumbers> hard_sums() {
  const std::array<float, 12> special = {0,   -0.0F,   1,        -1,       infinity,  -infinity,
                                         nan, largest, -largest, smallest, -smallest, 0x1p-126F};
  std::vector<ThreeNumbers> sums;
  for (const float a : special) {
    for (const float b : special) {
      for (const float c : special) sums.push_back({a, b, c});
    }
  }
  HardSums random;
  while (sums.size() < 300000) sums.push_back(random.next());
  return sums;
}

bool same(float a, float b) {
  return std::isnan(a) ? std::isnan(b)
                       : std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

TEST(engine_numbers, a_fused_multiply_add_is_rounded_once) {
  const std::vector<ThreeNumbers> sums = hard_sums();
  std::vector<float> expected;
  int known = 0;
  int rounded_twice = 0;
  for (const auto& [a, b, c] : sums) {
    const float fused = fused_multiply_add(a, b, c);
    expected.push_back(fused);
    if (!same(fused, static_cast<float>(static_cast<double>(a) * b + c))) ++rounded_twice;
    // Where 113 bits hold the sum, that's what it has to be.
    const Exact product = static_cast<Exact>(a) * b;
    const Exact sum = product + c;
    if (sum - product != c || sum - c != product) continue;
    ++known;
    ASSERT_TRUE(same(fused, static_cast<float>(sum))) << a << " * " << b << " + " << c;
  }
  EXPECT_GT(known, 150000);
  EXPECT_GT(rounded_twice, 1000) << "sums that doubles alone get wrong";
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    std::vector<float> results(sums.size());
    wide_numbers(simd).fused_multiply_add(sums, results.data());
    for (std::size_t i = 0; i < sums.size(); ++i) {
      ASSERT_TRUE(same(results[i], expected[i]))
          << std::hexfloat << sums[i].a << " * " << sums[i].b << " + " << sums[i].c << " gives "
          << results[i] << ", not " << expected[i];
    }
  }
}

/// Around every place where the byte changes.
std::vector<float> hard_colors() {
  std::vector<float> values = {nan,      -nan,      infinity, -infinity, largest, -largest,
                               smallest, -smallest, 0,        -0.0F,     1e6F,    -1e6F,
                               -70000,   70000,     0x1p31F,  -0x1p31F,  0x1p32F, -0x1p23F};
  for (int code = -1; code < 257; ++code) {
    float value = (static_cast<float>(code) + 0.5F) / 255;
    for (int i = 0; i < 4; ++i) value = std::nextafter(value, -infinity);
    for (int i = 0; i < 9; ++i, value = std::nextafter(value, infinity)) values.push_back(value);
  }
  return values;
}

/// The nearest, but for a product that is rounded to the next half.
TEST(engine_numbers, a_color_becomes_the_byte_that_to_byte_gives) {
  const std::vector<float> values = hard_colors();
  std::vector<ThreeNumbers> colors;
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = values[i];
    if (value >= 0 && value <= 1) {
      const auto away = static_cast<double>(static_cast<Exact>(value) * 255 - to_byte(value));
      ASSERT_LE(std::abs(away), 0.5 + 0x1p-16) << std::hexfloat << value;
    } else {
      ASSERT_EQ(to_byte(value), value > 1 ? 255 : 0) << value;
    }
    const float green = values[(i + 7) % values.size()];
    const float blue = values[(i + 400) % values.size()];
    colors.push_back({value, green, blue});
    expected.push_back(pack_texel(to_byte(value), to_byte(green), to_byte(blue)));
  }
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    std::vector<std::uint32_t> packed(colors.size());
    wide_numbers(simd).pack_color(colors, packed.data());
    for (std::size_t i = 0; i < colors.size(); ++i) {
      ASSERT_EQ(packed[i], expected[i])
          << std::hexfloat << colors[i].a << ", " << colors[i].b << ", " << colors[i].c;
    }
  }
}

}  // namespace
}  // namespace rasterlab

// Code for any Number, run on the oracles: the same to a float's precision, so that it is the same
// code; better than a float, so that it is an oracle.
#include "bench/support/oracle_number.h"

#include "common/image/number.h"
#include "common/texture/sample.h"

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// Of all that code for any Number may use. In the namespace where such code is.
template <class Number>
Number mixture(float a, float b) {
  const Vector3<Number> unit = normalized(Vector3<Number>(Number(a), Number(b), Number(1)));
  return power(unit.z(), Number(10)) + log_2(Number(a)) * round_down(Number(7) * unit.x()) +
         magnitude(minimum(unit.y(), Number(0)));
}

}  // namespace

namespace bench {
namespace {

TEST(bench_oracle_number, computes_what_floats_compute_and_better) {
  for (const auto& [a, b] : {std::pair{0.3F, -0.2F}, {1.7F, 0.9F}, {12.0F, -5.0F}}) {
    const double by_float = double{mixture<float>(a, b)};
    const double by_double = mixture<OracleNumber<double>>(a, b).value;
    const auto by_quad = static_cast<double>(mixture<OracleNumber<Quad>>(a, b).value);
    EXPECT_NEAR(by_float, by_double, 1e-5);
    EXPECT_NEAR(by_double, by_quad, 1e-13);
  }
}

TEST(bench_oracle_number, reads_textures_by_every_filter) {
  Image<Rgb8> image(8, 8);
  for (int i = 0; i < 64; ++i) image.pixels()[static_cast<std::size_t>(i)].g = std::uint8_t(3 * i);
  const Texture texture(image);
  const auto green = []<class Number>(const Sampler& sampler) {
    const auto step = [](float u, float v) { return Vector2<Number>(Number(u), Number(v)); };
    return sample<Number>(sampler, {step(0.31F, 0.62F), step(0.3F, 0.02F), step(0.01F, 0.14F)}).y();
  };
  for (const FilterRung& rung : filter_ladder()) {
    const Sampler sampler{&texture, rung.filter, Wrap::repeat};
    const double by_float = double{green.operator()<float>(sampler)};
    const double by_double = green.operator()<OracleNumber<double>>(sampler).value;
    const auto by_quad = static_cast<double>(green.operator()<OracleNumber<Quad>>(sampler).value);
    EXPECT_NEAR(by_float, by_double, 1e-6) << rung.name;
    EXPECT_NEAR(by_double, by_quad, 1e-14) << rung.name;
  }
}

}  // namespace
}  // namespace bench
}  // namespace rasterlab

// The filters of stage 06 on the oracles: the same code, better than a float.
#include "common/texture/sample.h"

#include "bench/support/oracle_number.h"

#include <gtest/gtest.h>

namespace rasterlab::bench {
namespace {

TEST(bench_filters, reads_textures_by_every_filter) {
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
}  // namespace rasterlab::bench

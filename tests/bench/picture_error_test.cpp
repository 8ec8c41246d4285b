#include "bench/support/picture_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rasterlab::bench {
namespace {

double value_of(const Errors& errors, const std::string& name) {
  for (const auto& [key, value] : errors) {
    if (key == "model: " + name) return value;
  }
  ADD_FAILURE() << "no error is called " << name;
  return 0;
}

Image<Rgb8> waves() {
  Image<Rgb8> picture(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto value =
          static_cast<std::uint8_t>(100 + 50 * std::sin(x * 0.7) * std::cos(y * 0.5));
      picture.row(y)[x] = {value, value, value};
    }
  }
  return picture;
}

TEST(bench_picture_error, equal_pictures_have_none) {
  const Errors errors = picture_errors("model", waves(), waves());
  EXPECT_EQ(value_of(errors, "largest, codes"), 0);
  EXPECT_EQ(value_of(errors, "% of pixels over 1 code"), 0);
  EXPECT_EQ(value_of(errors, "RMSE, codes"), 0);
  EXPECT_TRUE(std::isinf(value_of(errors, "PSNR, dB")));
  EXPECT_DOUBLE_EQ(value_of(errors, "SSIM"), 1);
}

TEST(bench_picture_error, one_channel_of_one_pixel_counts_as_the_definitions_say) {
  Image<Rgb8> other = waves();
  other(7, 9).g = static_cast<std::uint8_t>(other(7, 9).g + 12);
  const Errors errors = picture_errors("model", other, waves());
  const double rmse = std::sqrt(12.0 * 12 / (3 * 40 * 30));
  EXPECT_NEAR(value_of(errors, "largest, codes"), 12, 1e-4);
  EXPECT_NEAR(value_of(errors, "% of pixels over 1 code"), 100.0 / 1200, 1e-9);
  EXPECT_NEAR(value_of(errors, "RMSE, codes"), rmse, 1e-5);
  EXPECT_NEAR(value_of(errors, "PSNR, dB"), 20 * std::log10(255 / rmse), 1e-4);
}

/// Of two pictures of one colour each, a and b, SSIM is (2ab + c₁)/(a² + b² + c₁), whatever the
/// window; and what turns light into dark is not similar at all.
TEST(bench_picture_error, similarity_is_as_its_definition_has_it) {
  const Image<Rgb8> dark(20, 20, {80, 80, 80});
  const Image<Rgb8> light(20, 20, {120, 120, 120});
  const double c1 = 2.55 * 2.55;
  const double expected = (2 * 80.0 * 120 + c1) / (80.0 * 80 + 120.0 * 120 + c1);
  EXPECT_NEAR(value_of(picture_errors("model", dark, light), "SSIM"), expected, 1e-5);
  Image<Rgb8> inverse = waves();
  for (Rgb8& pixel : inverse.pixels()) {
    const auto value = static_cast<std::uint8_t>(200 - pixel.r);
    pixel = {value, value, value};
  }
  EXPECT_LT(value_of(picture_errors("model", inverse, waves()), "SSIM"), -0.5);
}

/// Where doubles cannot tell a colour from the truth, no figure is given.
TEST(bench_picture_error, what_the_oracles_do_not_agree_on_does_not_count) {
  Image<TrueColor> shown(4, 4, TrueColor::black());
  shown(1, 1).by_quad.x() = OracleNumber<Quad>(Quad{1e-20});
  const Errors errors = picture_errors("model", shown, Image<TrueColor>(4, 4, TrueColor::black()));
  EXPECT_TRUE(std::isnan(value_of(errors, "largest, codes")));
  EXPECT_TRUE(std::isnan(value_of(errors, "RMSE, codes")));
}

}  // namespace
}  // namespace rasterlab::bench

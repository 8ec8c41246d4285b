#include "common/shaders/draw_shaded.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/toy_lanes.h"

#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

TEST(stage07_quantize, bands_have_equal_widths) {
  for (int levels = 2; levels <= 9; ++levels) {
    for (int i = 0; i < 1024; ++i) {
      const int band = i * levels / 1024;
      EXPECT_EQ(quantize(static_cast<float>(i) / 1024, levels),
                static_cast<float>(band) / static_cast<float>(levels - 1))
          << i << "/1024 lies in band " << band << " of 0 … " << levels - 1
          << ", each of which is 1/" << levels << " wide";
    }
  }
}

TEST(stage07_quantize, one_is_in_the_highest_band) {
  EXPECT_EQ(quantize(1.0F, 5), 1) << "1 itself makes no sixth level";
  EXPECT_EQ(quantize(std::nextafter(1.0F, 0.0F), 5), 1);
  EXPECT_EQ(quantize(0.0F, 5), 0) << "the lowest level is black";
}

TEST(stage07_quantize, what_is_outside_counts_as_the_nearer_end) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float below : {-0.0F, -1e-30F, -0.3F, -7.0F, -infinity, std::nanf("")}) {
    EXPECT_EQ(quantize(below, 5), 0) << below;
  }
  for (const float above : {1.0001F, 1.3F, 8.0F, infinity}) EXPECT_EQ(quantize(above, 5), 1);
}

TEST(stage07_quantize, lanes_equal_one_float) {
  ToyLanes<8> values;
  values.lane = {-1, 0, 0.19F, 0.2F, 0.61F, 1, 2, std::nanf("")};
  const ToyLanes<8> wide = quantize(values, 5);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(wide.lane[i], quantize(values.lane[i], 5));
}

TEST(stage07_quantize, a_lit_sphere_has_five_shades_of_one_hue) {
  const TestScene scene("uv_sphere:24");
  ShaderInputs inputs = scene.inputs();
  inputs.color = Color(1, 0.5F, 0);
  Frame frame = make_frame(120, 120);
  frame.ids = Image<std::int32_t>(120, 120, -1);
  draw_shaded(scene.mesh, inputs.transforms, Cull::none, QuantizedGouraud<ConstantColor>(inputs),
              frame);
  std::set<int> reds;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      if (frame.ids(x, y) < 0) continue;
      const Rgb8 pixel = frame.color(x, y);
      reds.insert(pixel.r);
      EXPECT_NEAR(pixel.g, pixel.r / 2.0, 0.51) << "the light is quantized, not the colour";
      EXPECT_EQ(pixel.b, 0);
    }
  }
  EXPECT_THAT(reds, testing::ElementsAre(0, 64, 128, 191, 255));
}

}  // namespace
}  // namespace rasterlab

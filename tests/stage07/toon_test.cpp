// Follows the lab sheet's last section, "One of your own": the shader there is compiled as it
// stands, put into a list by the sheet's own line, and drawn with.
#include "tests/stage07/toon_test.h"

#include "common/engine/renderer.h"
#include "common/shaders/draw_shaded.h"

#include "tests/stage07/scene.h"

#include <set>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int side = 160;

struct ToonTest : testing::Test {
  Mesh knot = make_shape("torus_knot:16");
  ShaderInputs inputs = {.mesh = knot,
                         .transforms = TestScene::transforms(),
                         .light = {.position = {1, 2, 3, 0}},
                         .color = Color(1, 0.6F, 0.2F)};
};
using stage07_toon = ToonTest;

TEST_F(stage07_toon, one_line_puts_it_into_the_list) {
  const auto names = shader_names(list_of_the_sheet);
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[1].name, "toon");
  EXPECT_FALSE(names[1].description.empty());
}

TEST_F(stage07_toon, has_three_bands_and_ink) {
  Frame frame = make_frame(side, side);
  frame.ids = Image<std::int32_t>(side, side, -1);
  with_shader(list_of_the_sheet, "toon", inputs, [&](const auto& toon) {
    return draw_shaded(knot, inputs.transforms, Cull::none, toon, frame);
  });
  std::map<int, int> reds;
  for (std::size_t i = 0; i < frame.ids.pixels().size(); ++i) {
    if (frame.ids.pixels()[i] >= 0) ++reds[frame.color.pixels()[i].r];
  }
  EXPECT_EQ(reds.size(), 4U) << testing::PrintToString(reds);
  for (const auto& [red, pixels] : reds) EXPECT_GT(pixels, 100) << "red " << red;
  EXPECT_EQ(reds.begin()->first, 0) << "the ink is black";
  EXPECT_EQ(reds.rbegin()->first, 255) << "the brightest band is the colour itself";
}

TEST_F(stage07_toon, the_engine_draws_it_too) {
  Frame expected = make_frame(side, side);
  Framebuffer actual(side, side);
  actual.clear();
  with_shader(list_of_the_sheet, "toon", inputs, [&](const auto& toon) {
    draw_shaded(knot, inputs.transforms, Cull::none, toon, expected);
    const PreparedMesh prepared(knot);
    if constexpr (std::is_same_v<std::decay_t<decltype(toon)>, Toon>) {
      Renderer().draw({.mesh = &prepared,
                       .matrix = inputs.transforms.to_clip(),
                       .cull = Cull::none,
                       .mirrored = false,
                       .shading = shading(toon)},
                      actual);
    }
    return true;
  });
  const Image<Rgb8> picture = actual.color();
  int different = 0;
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (!(picture.pixels()[i] == expected.color.pixels()[i])) ++different;
  }
  EXPECT_LE(different, 5) << "a pixel at the edge of a band may fall on its other side";
}

}  // namespace
}  // namespace rasterlab

#include "common/texture/texture.h"

#include "common/texture/sample.h"

#include "tests/stage06/noise.h"
#include "tests/stage06/quad.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// What part of [low, high] lies in [i, i + 1].
Quad overlap(Quad low, Quad high, int i) {
  const Quad begin = low > i ? low : static_cast<Quad>(i);
  const Quad end = high < i + 1 ? high : static_cast<Quad>(i + 1);
  return begin < end ? end - begin : 0;
}

/// The mean of the red channel over texel (column, row) of a level with these sides, by the
/// definition, from the texture's picture; row counts from the bottom.
Quad mean_red(const Image<Rgb8>& image, int width, int height, int column, int row) {
  const Quad across = static_cast<Quad>(image.width()) / width;
  const Quad down = static_cast<Quad>(image.height()) / height;
  const int from_top = height - 1 - row;
  Quad sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      sum += overlap(column * across, (column + 1) * across, x) *
             overlap(from_top * down, (from_top + 1) * down, y) * image(x, y).r;
    }
  }
  return sum / (across * down);
}

TEST(stage06_texture, has_its_corners_where_they_belong) {
  Image<Rgb8> image(2, 3);
  image(0, 0) = {255, 0, 0};      // top left: v near 1
  image(1, 0) = {0, 255, 0};      // top right
  image(0, 2) = {0, 0, 255};      // bottom left: v near 0
  image(1, 2) = {255, 255, 255};  // bottom right
  const Texture texture(image);
  const auto color = [&](float u, float v) {
    return to_rgb8(sample_nearest(texture, Wrap::clamp, Footprint<float>{{u, v}, {0, 0}, {0, 0}}));
  };
  EXPECT_EQ(color(0, 1), image(0, 0));
  EXPECT_EQ(color(1, 1), image(1, 0));
  EXPECT_EQ(color(0, 0), image(0, 2));
  EXPECT_EQ(color(1, 0), image(1, 2));
  EXPECT_EQ(color(0.49F, 0.9F), image(0, 0));
  EXPECT_EQ(color(0.5F, 0.9F), image(1, 0)) << "a texel owns its left edge";
  EXPECT_EQ(color(0.2F, 0.34F), image(0, 1));
  EXPECT_EQ(color(0.2F, 0.33F), image(0, 2));
}

TEST(stage06_texture, levels_halve_down_to_one_texel) {
  for (const auto& [width, height, count] :
       {std::array{1, 1, 1}, {2, 2, 2}, {8, 8, 4}, {8, 2, 4}, {1, 16, 5}, {5, 3, 3}, {17, 31, 5}}) {
    const Texture texture(Image<Rgb8>(width, height));
    EXPECT_EQ(texture.level_count(), count) << width << " x " << height;
    const auto last = texture.level(static_cast<float>(count - 1));
    EXPECT_EQ(last.width, 1);
    EXPECT_EQ(last.height, 1);
    EXPECT_EQ(texture.levels_left_out(), 0);
    const Texture flat(Image<Rgb8>(width, height), MipLevels::none);
    EXPECT_EQ(flat.level_count(), 1);
    EXPECT_EQ(flat.levels_left_out(), count - 1) << width << " x " << height;
  }
  const Image<Rgb8> long_image(1 << 17, 1);
  EXPECT_EQ(Texture(long_image).level_count(), Texture::max_levels);
  EXPECT_EQ(Texture(long_image, MipLevels::none).levels_left_out(), Texture::max_levels - 1);
}

TEST(stage06_texture, needs_a_texel) {
  EXPECT_THROW(Texture(Image<Rgb8>()), CheckError);
}

// With sides that are powers of two, a level's texel is the mean of whole texels of the picture;
// each level is rounded to bytes but once, whatever its depth.
TEST(stage06_texture, levels_are_means_of_the_picture) {
  for (const auto& [width, height] : {std::array{16, 16}, {8, 32}, {1, 8}}) {
    const Image<Rgb8> image = noise(width, height, 1);
    const Texture texture(image);
    for (int i = 0; i < texture.level_count(); ++i) {
      const auto level = texture.level(static_cast<float>(i));
      for (int row = 0; row < static_cast<int>(level.height); ++row) {
        for (int column = 0; column < static_cast<int>(level.width); ++column) {
          const Quad mean = mean_red(image, static_cast<int>(level.width),
                                     static_cast<int>(level.height), column, row);
          EXPECT_EQ(texture.texel(level, static_cast<float>(column), static_cast<float>(row)).x(),
                    std::floor(static_cast<double>(mean) + 0.5))
              << "halves up";
        }
      }
    }
  }
}

// Odd sides: the first level down cuts texels through.
TEST(stage06_texture, levels_of_odd_sides_count_parts_of_texels) {
  for (const auto& [width, height] : {std::array{5, 3}, {7, 7}, {17, 1}, {3, 10}}) {
    const Image<Rgb8> image = noise(width, height, 2);
    const Texture texture(image);
    const auto level = texture.level(1.0F);
    for (int row = 0; row < static_cast<int>(level.height); ++row) {
      for (int column = 0; column < static_cast<int>(level.width); ++column) {
        const Quad mean = mean_red(image, static_cast<int>(level.width),
                                   static_cast<int>(level.height), column, row);
        EXPECT_LE(difference(
                      texture.texel(level, static_cast<float>(column), static_cast<float>(row)).x(),
                      mean),
                  0.5 + 1e-4)
            << width << " x " << height << " at " << column << ", " << row;
      }
    }
  }
}

TEST(stage06_texture, halving_keeps_the_mean) {
  for (int width = 2; width < 20; ++width) {
    Image<Color> image(width, 3, Color::Zero());
    for (int x = 0; x < width; ++x) image(x, 1) = Color(static_cast<float>(x), 1, 0);
    Color sum = Color::Zero();
    const Image<Color> half = halved(image);
    for (const Color& color : half.pixels()) sum += color;
    const float expected = static_cast<float>(width - 1) / 2 / 3;
    EXPECT_NEAR(sum.x() / static_cast<float>(half.pixels().size()), expected, 1e-5);
    EXPECT_NEAR(sum.y() / static_cast<float>(half.pixels().size()), 1.0 / 3, 1e-6);
  }
}

// 4200² texels are more than a float can count.
TEST(stage06_texture, the_last_texel_of_a_large_picture) {
  Image<Rgb8> image(4200, 4200, {1, 2, 3});
  image(4199, 0) = {200, 100, 50};
  image(4198, 0) = {10, 20, 30};
  const Texture texture(image, MipLevels::none);
  const auto color = [&](float u, float v) {
    return to_rgb8(sample_nearest(texture, Wrap::repeat, Footprint<float>{{u, v}, {0, 0}, {0, 0}}));
  };
  EXPECT_EQ(color(1, 1), image(4199, 0));
  EXPECT_EQ(color(4198.5F / 4200, 1), image(4198, 0));
  EXPECT_EQ(color(0, 0), (Rgb8{1, 2, 3}));
}

}  // namespace
}  // namespace rasterlab

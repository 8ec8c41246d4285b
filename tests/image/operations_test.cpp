#include "common/image/operations.h"

#include "common/image/convert.h"

#include "tests/image/corners.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Grey = std::uint8_t;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Image<Grey> image_of(int width, const std::vector<Grey>& pixels) {
  Image<Grey> image(width, static_cast<int>(pixels.size()) / width);
  image.pixels() = pixels;
  return image;
}

TEST(stage01_image_operations, flips) {
  const Image<Grey> image = image_of(3, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(flipped_horizontally(image), image_of(3, {3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(flipped_vertically(image), image_of(3, {4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(flipped_vertically(flipped_vertically(many_colors(7, 5))), many_colors(7, 5));
  EXPECT_TRUE(flipped_horizontally(Image<Grey>()).empty());
}

TEST(stage01_image_operations, enlarged_by_a_factor) {
  EXPECT_EQ(enlarged(image_of(2, {1, 2}), 2), image_of(4, {1, 1, 2, 2, 1, 1, 2, 2}));
  EXPECT_EQ(enlarged(many_colors(5, 3), 1), many_colors(5, 3));
  EXPECT_THROW(enlarged(many_colors(5, 3), 0), CheckError);
  EXPECT_THROW(enlarged(many_colors(5, 3), 1 << 16), CheckError);
  EXPECT_THROW(enlarged(many_colors(5, 3), std::numeric_limits<int>::max()), CheckError);
}

TEST(stage01_image_operations, resized_takes_the_pixel_under_the_centre) {
  EXPECT_EQ(resized(image_of(4, {1, 2, 3, 4}), 2, 1), image_of(2, {2, 4}));
  EXPECT_EQ(resized(image_of(3, {1, 2, 3}), 1, 1), image_of(1, {2}));
  EXPECT_EQ(resized(image_of(2, {1, 2}), 3, 2), image_of(3, {1, 2, 2, 1, 2, 2}));
  EXPECT_EQ(resized(many_colors(5, 3), 0, 7).height(), 7);
  EXPECT_THROW(resized(Image<Grey>(), 2, 2), CheckError);
  EXPECT_THROW(resized(many_colors(5, 3), -1, 2), CheckError);
}

TEST(stage01_image_operations, pasted_where_it_fits) {
  Image<Grey> whole(3, 2, 9);
  paste(image_of(2, {1, 2, 3, 4}), 2, -1, whole);
  EXPECT_EQ(whole, image_of(3, {9, 9, 3, 9, 9, 9}));
  paste(image_of(2, {1, 2, 3, 4}), -1, 1, whole);
  EXPECT_EQ(whole, image_of(3, {9, 9, 3, 2, 9, 9}));
}

TEST(stage01_image_operations, side_by_side_in_rows) {
  const std::vector<Image<Grey>> pictures(3, image_of(1, {7}));
  EXPECT_EQ(side_by_side(pictures, 2), image_of(3, {7, 0, 7, 0, 0, 0, 7, 0, 0}));
  EXPECT_EQ(side_by_side(pictures, 5), image_of(5, {7, 0, 7, 0, 7}));
  EXPECT_TRUE(side_by_side(std::vector<Image<Grey>>(), 2).empty());
  EXPECT_THROW(side_by_side(pictures, 0), CheckError);
}

TEST(stage01_image_operations, numbers_as_grey) {
  Image<float> values(6, 1);
  values.pixels() = {2, 3, 4, infinity, -infinity, not_a_number};
  EXPECT_EQ(grey_picture(values, 2, 4), image_of(6, {0, 128, 255, 255, 0, 0}));
  EXPECT_EQ(grey_picture(values, 4, 2), image_of(6, {255, 128, 0, 0, 255, 0}));
  EXPECT_THROW(grey_picture(values, 1, 1), CheckError);
  EXPECT_THROW(grey_picture(values, 1, infinity), CheckError);
  EXPECT_EQ(finite_range(values), std::pair(2.0F, 4.0F));
  EXPECT_EQ(finite_range(Image<float>(1, 1, infinity)), std::pair(0.0F, 0.0F));
}

TEST(stage01_image_operations, clear_sets_every_pixel) {
  Image<Rgb8> image = many_colors(5, 3);
  image.clear({1, 2, 3});
  EXPECT_EQ(image, Image<Rgb8>(5, 3, {1, 2, 3}));
}

// --- convert ---

template <class To, class From>
To converted(const From& pixel) {
  return convert<To>(Image<From>(1, 1, pixel))(0, 0);
}

TEST(stage01_image_convert, every_8_bit_value_survives_every_way_round) {
  for (int i = 0; i < 256; ++i) {
    const auto grey = static_cast<Grey>(i);
    EXPECT_EQ(converted<Grey>(converted<std::uint16_t>(grey)), grey);
    EXPECT_EQ(converted<std::uint16_t>(grey), i * 257);
    EXPECT_EQ(converted<Grey>(converted<float>(grey)), grey);
    EXPECT_EQ(converted<Grey>(converted<Rgb8>(grey)), grey);
    EXPECT_EQ(converted<Grey>(converted<Color>(grey)), grey);
    const Rgba8 color{grey, 1, 2, grey};
    EXPECT_EQ(converted<Rgba8>(converted<Rgba16>(color)), color);
  }
}

TEST(stage01_image_convert, every_16_bit_value_survives_as_float) {
  for (int i = 0; i < 65536; ++i) {
    const auto grey = static_cast<std::uint16_t>(i);
    ASSERT_EQ(converted<std::uint16_t>(converted<float>(grey)), grey);
  }
}

TEST(stage01_image_convert, color_to_grey_is_weighted) {
  EXPECT_EQ(converted<Grey>(Rgb8{255, 0, 0}), 76);
  EXPECT_EQ(converted<Grey>(Rgb8{0, 255, 0}), 150);
  EXPECT_EQ(converted<Grey>(Rgb8{0, 0, 255}), 29);
}

TEST(stage01_image_convert, alpha_is_opaque_or_dropped) {
  EXPECT_EQ(converted<Rgba8>(Rgb8{1, 2, 3}), (Rgba8{1, 2, 3, 255}));
  EXPECT_EQ(converted<Rgb8>(Rgba8{1, 2, 3, 4}), (Rgb8{1, 2, 3}));
}

TEST(stage01_image_convert, floats_are_clamped_into_integers_and_kept_among_floats) {
  EXPECT_EQ(converted<Grey>(2.0F), 255);
  EXPECT_EQ(converted<Grey>(infinity), 255);
  EXPECT_EQ(converted<Grey>(-1.0F), 0);
  EXPECT_EQ(converted<std::uint16_t>(not_a_number), 0);
  EXPECT_EQ(converted<float>(converted<Color>(infinity)), infinity);
  EXPECT_EQ(converted<Color>(-7.5F), Color(-7.5F, -7.5F, -7.5F));
}

TEST(stage01_image_convert, kind_known_at_run_time) {
  const AnyImage image = Image<Rgba8>(2, 3);
  for (const Depth depth : {Depth::bits8, Depth::bits16, Depth::floating}) {
    for (const int channels : {1, 3, 4}) {
      const AnyImage result = convert(image, {channels, depth});
      const bool no_alpha = depth == Depth::floating && channels == 4;
      EXPECT_EQ(kind_of(result), (PixelKind{no_alpha ? 3 : channels, depth}));
      EXPECT_EQ(height_of(result), 3);
    }
  }
}

}  // namespace
}  // namespace rasterlab

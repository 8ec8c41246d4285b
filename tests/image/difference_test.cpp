#include "common/image/difference.h"

#include "tests/image/corners.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

TEST(stage01_image_difference, same_pictures_match) {
  const Difference difference = compare_images(many_colors(9, 7), many_colors(9, 7));
  EXPECT_TRUE(difference.matches);
  EXPECT_EQ(difference.differing_pixels, 0U);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.kind_of_wrong, "");
}

TEST(stage01_image_difference, counts_pixels_and_shows_the_first) {
  const Image<Rgb8> expected(20, 10, {10, 20, 30});
  Image<Rgb8> actual = expected;
  for (int x = 5; x < 15; ++x) actual(x, 4) = {10, 22, 30};
  actual(19, 9) = {0, 20, 30};
  const Difference difference = compare_images(actual, expected);
  EXPECT_FALSE(difference.matches);
  EXPECT_EQ(difference.differing_pixels, 11U);
  EXPECT_EQ(difference.largest, 10);
  ASSERT_EQ(difference.first.size(), 8U);
  EXPECT_EQ(difference.first[0].x, 5);
  EXPECT_EQ(difference.first[0].y, 4);
  EXPECT_EQ(difference.first[0].actual, "(10, 22, 30)");
  EXPECT_EQ(difference.first[0].expected, "(10, 20, 30)");
  EXPECT_THAT(describe(difference), testing::HasSubstr("11 of 200 pixels differ"));
  EXPECT_THAT(describe(difference), testing::HasSubstr("(5, 4) is (10, 22, 30), expected"));
}

TEST(stage01_image_difference, both_limits_hold) {
  const Image<std::uint8_t> expected(10, 1, 100);
  Image<std::uint8_t> actual = expected;
  actual(0, 0) = 102;
  actual(1, 0) = 97;
  const auto matches = [&](double max_difference, std::size_t total_pixels) {
    return compare_images(actual, expected, {max_difference, total_pixels}).matches;
  };
  EXPECT_TRUE(matches(3, 2));
  EXPECT_FALSE(matches(2, 2));
  EXPECT_FALSE(matches(3, 1));
  EXPECT_FALSE(matches(0, 0));
  EXPECT_TRUE(matches(3, Tolerance::any_number));
  EXPECT_TRUE(matches(Tolerance::any_difference, 2));
}

TEST(stage01_image_difference, neighbors_count_only_when_asked_for) {
  Image<std::uint8_t> actual(9, 9);
  Image<std::uint8_t> expected(9, 9);
  actual(4, 4) = 255;
  expected(5, 3) = 255;
  EXPECT_FALSE(compare_images(actual, expected).matches);
  EXPECT_TRUE(compare_images(actual, expected, {.neighbor_radius = 1}).matches);
  actual(4, 4) = 0;  // Missing altogether: every actual pixel has its like, but not every expected.
  EXPECT_FALSE(compare_images(actual, expected, {.neighbor_radius = 1}).matches);
  expected(5, 3) = 0;
  actual(8, 8) = 255;
  EXPECT_FALSE(compare_images(actual, expected, {.neighbor_radius = 1 << 30}).matches);
}

TEST(stage01_image_difference, floats_with_infinities_and_nan) {
  Image<float> actual(3, 1, infinity);
  Image<float> expected = actual;
  actual(2, 0) = expected(2, 0) = not_a_number;
  EXPECT_TRUE(compare_images(actual, expected).matches);
  expected(2, 0) = 1;
  EXPECT_EQ(compare_images(actual, expected).largest, infinity);
  EXPECT_FALSE(compare_images(actual, expected, {1e30, 5}).matches);
  actual(2, 0) = 1.25F;
  const Difference difference = compare_images(actual, expected);
  EXPECT_EQ(difference.largest, 0.25);
  EXPECT_EQ(difference.first.at(0).actual, "1.25");
  actual(0, 0) = 3;
  EXPECT_EQ(compare_images(actual, expected).largest, infinity);
  EXPECT_TRUE(compare_images(actual, expected, {Tolerance::any_difference, 2}).matches);
}

TEST(stage01_image_difference, kinds_of_pixel_are_brought_together) {
  const Image<std::uint8_t> grey(3, 2, 51);
  EXPECT_TRUE(compare_images(grey, Image<Rgb8>(3, 2, {51, 51, 51})).matches);
  EXPECT_TRUE(compare_images(grey, Image<Rgba8>(3, 2, {51, 51, 51, 255})).matches);
  EXPECT_FALSE(compare_images(grey, Image<Rgba8>(3, 2, {51, 51, 51, 254})).matches);
  EXPECT_TRUE(compare_images(grey, Image<std::uint16_t>(3, 2, 51 * 257)).matches);
  EXPECT_EQ(compare_images(grey, Image<std::uint16_t>(3, 2, 51 * 257 + 1)).largest, 1);
  EXPECT_TRUE(compare_images(grey, Image<float>(3, 2, 51.0F / 255.0F)).matches);
  EXPECT_TRUE(
      compare_images(Image<Rgba8>(1, 1, {0, 0, 255, 9}), Image<Color>(1, 1, {0, 0, 1})).matches);
}

TEST(stage01_image_difference, another_size_never_matches) {
  const Difference difference = compare_images(four_corners(64, 32), four_corners(32, 64),
                                               {Tolerance::any_difference, Tolerance::any_number});
  EXPECT_FALSE(difference.matches);
  EXPECT_EQ(describe(difference), "the size is 64x32, expected 32x64\n");
  EXPECT_FALSE(compare_images(Image<Rgb8>(), Image<Rgb8>(1, 1)).matches);
  EXPECT_TRUE(compare_images(Image<Rgb8>(), Image<Rgb8>()).matches);
}

TEST(stage01_image_difference, picture_amplifies) {
  Image<Rgb8> actual(3, 2, {100, 100, 100});
  const Image<Rgb8> expected = actual;
  actual(0, 0) = {102, 100, 100};
  actual(1, 0) = {100, 99, 100};
  const Image<Rgb8> picture = difference_picture(actual, expected);
  EXPECT_EQ(picture(0, 0), (Rgb8{255, 0, 0}));
  EXPECT_EQ(picture(1, 0).r, 0);
  EXPECT_GE(picture(1, 0).g, 64);
  EXPECT_EQ(picture(2, 1), (Rgb8{0, 0, 0}));
}

TEST(stage01_image_difference, picture_of_other_sizes_marks_what_one_lacks) {
  const Image<Rgb8> picture =
      difference_picture(Image<std::uint8_t>(3, 1, 7), Image<std::uint8_t>(1, 2, 7));
  ASSERT_EQ(picture.width(), 3);
  ASSERT_EQ(picture.height(), 2);
  EXPECT_EQ(picture(0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(picture(2, 0), (Rgb8{255, 0, 255}));
  EXPECT_EQ(picture(0, 1), (Rgb8{255, 0, 255}));
}

TEST(stage01_image_difference, picture_shows_alpha_and_infinite_differences) {
  const Rgb8 alpha =
      difference_picture(Image<Rgba8>(1, 1, {1, 2, 3, 4}), Image<Rgba8>(1, 1, {1, 2, 3, 5}))(0, 0);
  EXPECT_EQ(alpha, (Rgb8{255, 255, 255}));
  Image<float> actual(2, 1, infinity);
  actual(1, 0) = 1;
  const Image<Rgb8> picture = difference_picture(actual, Image<float>(2, 1, 0.5F));
  EXPECT_EQ(picture(0, 0), (Rgb8{255, 255, 255}));
  EXPECT_EQ(picture(1, 0), (Rgb8{255, 255, 255}));  // the largest finite difference
}

}  // namespace
}  // namespace rasterlab

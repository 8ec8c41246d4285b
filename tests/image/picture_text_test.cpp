#include "tests/support/picture_text.h"

#include "common/image/pixel.h"

#include <cstdint>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

TEST(stage01_picture_text, drawn_pixels_are_hashes) {
  Image<Rgb8> image(3, 2);
  image(2, 0) = {0, 0, 1};
  image(0, 1) = {255, 0, 0};
  EXPECT_EQ(picture_text(image), (PictureText{"..#", "#.."}));
  EXPECT_TRUE(covers_exactly(image, {"..#", "#.."}));
}

TEST(stage01_picture_text, failure_shows_missing_and_extra) {
  const testing::AssertionResult result = same_picture({"##.", "..."}, {"#.#", "..."});
  EXPECT_FALSE(result);
  EXPECT_THAT(result.message(), testing::HasSubstr("\n  #!?\n  ..."));
}

TEST(stage01_picture_text, another_size_is_another_picture) {
  const testing::AssertionResult result = same_picture({"#."}, {"#.", ".."});
  EXPECT_FALSE(result);
  EXPECT_THAT(result.message(), testing::HasSubstr("2x1, expected 2x2"));
}

TEST(stage01_picture_text, other_characters_are_compared_too) {
  Image<std::uint8_t> image(2, 1);
  image(0, 0) = 1;
  image(1, 0) = 2;
  const PictureText text =
      picture_text_by(image, [](std::uint8_t value) { return static_cast<char>('0' + value); });
  EXPECT_EQ(text, PictureText{"12"});
  EXPECT_EQ(overlay(text, {"13"}), PictureText{"1x"});
}

}  // namespace
}  // namespace rasterlab

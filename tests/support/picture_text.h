// Small pictures as text, one character a pixel, so that a test shows what it expects and a failure
// what is wrong.
#pragma once

#include "common/image/image.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterlab {

/// A picture as rows of text from the top: `#` drawn, `.` not.
using PictureText = std::vector<std::string>;

/// `#` where a pixel is not `background`.
template <class Pixel>
PictureText picture_text(const Image<Pixel>& image,
                         const Pixel& background = blank_pixel<Pixel>()) {
  PictureText text(static_cast<std::size_t>(image.height()),
                   std::string(static_cast<std::size_t>(image.width()), '.'));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!(image(x, y) == background))
        text[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
    }
  }
  return text;
}

/// Each pixel as a character that `to_character` gives it.
template <class Pixel, class ToCharacter>
PictureText picture_text_by(const Image<Pixel>& image, ToCharacter to_character) {
  PictureText text(static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      text[static_cast<std::size_t>(y)] += to_character(image(x, y));
  }
  return text;
}

/// The two laid over each other: `#` and any other character where they agree, `?` missing (drawn
/// in `expected` alone),
/// `!` extra (drawn in `actual` alone), `x` drawn in both but differently. A row or column that
/// only one of them has counts as not drawn in the other.
PictureText overlay(const PictureText& actual, const PictureText& expected);

/// Compares, and on failure shows the overlay. Use: EXPECT_TRUE(same_picture(picture_text(image),
/// {".##.",
///                                                                                                "####"}));
testing::AssertionResult same_picture(const PictureText& actual, const PictureText& expected);

/// The usual case: what is not background must be exactly the `#` of `expected`, and the size the
/// same.
template <class Pixel>
testing::AssertionResult covers_exactly(const Image<Pixel>& image, const PictureText& expected) {
  return same_picture(picture_text(image), expected);
}

}  // namespace rasterlab

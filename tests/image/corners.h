// The picture that tells every way up from every other: red top left, green top right, blue bottom
// left, white bottom right. Wider than high, so that transposed is another size.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>

namespace rasterlab {

inline Image<Rgb8> four_corners(int width = 64, int height = 32) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool right = x >= width / 2;
      const bool bottom = y >= height / 2;
      image(x, y) = bottom ? (right ? Rgb8{255, 255, 255} : Rgb8{0, 0, 255})
                           : (right ? Rgb8{0, 255, 0} : Rgb8{255, 0, 0});
    }
  }
  return image;
}

/// Every channel of every pixel different from its neighbours'.
inline Image<Rgb8> many_colors(int width, int height) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int i = y * width + x;
      image(x, y) = {static_cast<std::uint8_t>(i * 37 + 11), static_cast<std::uint8_t>(i * 101 + 3),
                     static_cast<std::uint8_t>(i * 59 + 200)};
    }
  }
  return image;
}

}  // namespace rasterlab

// Pictures in which no two neighbours are alike.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>
#include <random>

namespace rasterlab {

/// Every channel of every pixel a random number.
inline Image<Rgb8> noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255);
  Image<Rgb8> image(width, height);
  for (Rgb8& pixel : image.pixels()) {
    pixel = {static_cast<std::uint8_t>(byte(random)), static_cast<std::uint8_t>(byte(random)),
             static_cast<std::uint8_t>(byte(random))};
  }
  return image;
}

}  // namespace rasterlab

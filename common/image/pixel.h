// The kinds of pixel, and how a colour that is computed becomes one that is stored.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// A colour while computing: red, green, blue, nominally in [0, 1]. Linear in what is stored: no
/// hidden gamma.
using Color = Eigen::Vector3f;

/// A stored colour, 8 bit a channel, red first in memory.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// A stored colour with straight (not premultiplied) alpha.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// A stored colour, 16 bit a channel.
struct Rgb16 {
  std::uint16_t r = 0;
  std::uint16_t g = 0;
  std::uint16_t b = 0;
  friend bool operator==(const Rgb16&, const Rgb16&) = default;
};

/// A stored colour, 16 bit a channel, with straight alpha.
struct Rgba16 {
  std::uint16_t r = 0;
  std::uint16_t g = 0;
  std::uint16_t b = 0;
  std::uint16_t a = 65535;
  friend bool operator==(const Rgba16&, const Rgba16&) = default;
};

/// [0, 1] to 0…255, rounded to nearest; below 0 and NaN become 0, above 1 becomes 255.
inline std::uint8_t to_byte(float value) {
  // These operations, so that SIMD code can do the same.
  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
  return value > 0 ? static_cast<std::uint8_t>(std::min(value, 1.0F) * 255.0F + 0.5F)
                   : std::uint8_t{0};
}

inline Rgb8 to_rgb8(const Color& color) {
  return {to_byte(color.x()), to_byte(color.y()), to_byte(color.z())};
}

inline Color to_color(const Rgb8& pixel) {
  return Color(static_cast<float>(pixel.r), static_cast<float>(pixel.g),
               static_cast<float>(pixel.b)) /
         255.0F;
}

}  // namespace rasterlab

#include "common/image/convert.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace rasterlab {
namespace {

/// The value every kind of pixel passes through: 24 bits of mantissa hold 16 bits of k / 65535.
struct Channels {
  float r = 0;
  float g = 0;
  float b = 0;
  float a = 1;
};

float to_unit(std::uint8_t value) {
  return static_cast<float>(value) / 255.0F;
}
float to_unit(std::uint16_t value) {
  return static_cast<float>(value) / 65535.0F;
}

template <class Sample>
Sample from_unit(float value);
template <>
std::uint8_t from_unit(float value) {
  return to_byte(value);
}
template <>
std::uint16_t from_unit(float value) {
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): as to_byte()
  return value > 0 ? static_cast<std::uint16_t>(std::min(value, 1.0F) * 65535.0F + 0.5F)
                   : std::uint16_t{0};
}

template <class Pixel>
Channels channels_of(const Pixel& pixel) {
  if constexpr (std::is_same_v<Pixel, float>) {
    return {pixel, pixel, pixel, 1};
  } else if constexpr (std::is_integral_v<Pixel>) {
    return {to_unit(pixel), to_unit(pixel), to_unit(pixel), 1};
  } else if constexpr (std::is_same_v<Pixel, Color>) {
    return {pixel.x(), pixel.y(), pixel.z(), 1};
  } else if constexpr (pixel_kind<Pixel>.channels == 3) {
    return {to_unit(pixel.r), to_unit(pixel.g), to_unit(pixel.b), 1};
  } else {
    return {to_unit(pixel.r), to_unit(pixel.g), to_unit(pixel.b), to_unit(pixel.a)};
  }
}

float grey_of(const Channels& c) {
  return c.r == c.g && c.g == c.b ? c.r : 0.299F * c.r + 0.587F * c.g + 0.114F * c.b;
}

template <class Pixel>
Pixel pixel_of(const Channels& c) {
  if constexpr (std::is_same_v<Pixel, float>) {
    return grey_of(c);
  } else if constexpr (std::is_integral_v<Pixel>) {
    return from_unit<Pixel>(grey_of(c));
  } else if constexpr (std::is_same_v<Pixel, Color>) {
    return {c.r, c.g, c.b};
  } else {
    using Sample = decltype(Pixel::r);
    Pixel pixel{from_unit<Sample>(c.r), from_unit<Sample>(c.g), from_unit<Sample>(c.b)};
    if constexpr (pixel_kind<Pixel>.channels == 4) pixel.a = from_unit<Sample>(c.a);
    return pixel;
  }
}

template <class Pixel>
AnyImage convert_any(const AnyImage& image) {
  return std::visit([](const auto& pixels) -> AnyImage { return convert<Pixel>(pixels); }, image);
}

}  // namespace

template <class To, class From>
Image<To> convert(const Image<From>& image) {
  if constexpr (std::is_same_v<To, From>) {
    return image;
  } else {
    Image<To> result(image.width(), image.height());
    std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                   [](const From& pixel) { return pixel_of<To>(channels_of(pixel)); });
    return result;
  }
}

AnyImage convert(const AnyImage& image, PixelKind kind) {
  const bool grey = kind.channels == 1;
  const bool alpha = kind.channels == 4;
  switch (kind.depth) {
    case Depth::bits8:
      return grey    ? convert_any<std::uint8_t>(image)
             : alpha ? convert_any<Rgba8>(image)
                     : convert_any<Rgb8>(image);
    case Depth::bits16:
      return grey    ? convert_any<std::uint16_t>(image)
             : alpha ? convert_any<Rgba16>(image)
                     : convert_any<Rgb16>(image);
    case Depth::floating:
      break;
  }
  return grey ? convert_any<float>(image) : convert_any<Color>(image);
}

#define RASTERLAB_CONVERT(To, From) template Image<To> convert(const Image<From>&);
#define RASTERLAB_CONVERT_TO(To)       \
  RASTERLAB_CONVERT(To, std::uint8_t)  \
  RASTERLAB_CONVERT(To, std::uint16_t) \
  RASTERLAB_CONVERT(To, Rgb8)          \
  RASTERLAB_CONVERT(To, Rgb16)         \
  RASTERLAB_CONVERT(To, Rgba8)         \
  RASTERLAB_CONVERT(To, Rgba16)        \
  RASTERLAB_CONVERT(To, float)         \
  RASTERLAB_CONVERT(To, Color)
RASTERLAB_CONVERT_TO(std::uint8_t)
RASTERLAB_CONVERT_TO(std::uint16_t)
RASTERLAB_CONVERT_TO(Rgb8)
RASTERLAB_CONVERT_TO(Rgb16)
RASTERLAB_CONVERT_TO(Rgba8)
RASTERLAB_CONVERT_TO(Rgba16)
RASTERLAB_CONVERT_TO(float)
RASTERLAB_CONVERT_TO(Color)

}  // namespace rasterlab

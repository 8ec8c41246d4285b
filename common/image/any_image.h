// A picture of any kind of pixel a file can hold, for code that takes pictures as they come.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

namespace rasterlab {

/// A picture with the pixels its file stores: grey or colour, with or without alpha, 8 bit, 16 bit
/// or float.
using AnyImage = std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<Rgb8>, Image<Rgb16>,
                              Image<Rgba8>, Image<Rgba16>, Image<float>, Image<Color>>;

/// How one channel is stored, coarsest first.
enum class Depth { bits8, bits16, floating };

/// What tells AnyImage's kinds of pixel apart.
struct PixelKind {
  int channels = 1;  ///< 1 grey, 3 red green blue, 4 with alpha
  Depth depth = Depth::bits8;
  friend bool operator==(const PixelKind&, const PixelKind&) = default;
};

template <class Pixel>
inline constexpr PixelKind pixel_kind{};
template <>
inline constexpr PixelKind pixel_kind<std::uint8_t>{1, Depth::bits8};
template <>
inline constexpr PixelKind pixel_kind<std::uint16_t>{1, Depth::bits16};
template <>
inline constexpr PixelKind pixel_kind<Rgb8>{3, Depth::bits8};
template <>
inline constexpr PixelKind pixel_kind<Rgb16>{3, Depth::bits16};
template <>
inline constexpr PixelKind pixel_kind<Rgba8>{4, Depth::bits8};
template <>
inline constexpr PixelKind pixel_kind<Rgba16>{4, Depth::bits16};
template <>
inline constexpr PixelKind pixel_kind<float>{1, Depth::floating};
template <>
inline constexpr PixelKind pixel_kind<Color>{3, Depth::floating};

inline int width_of(const AnyImage& image) {
  return std::visit([](const auto& pixels) { return pixels.width(); }, image);
}
inline int height_of(const AnyImage& image) {
  return std::visit([](const auto& pixels) { return pixels.height(); }, image);
}
inline PixelKind kind_of(const AnyImage& image) {
  return std::visit([]<class Pixel>(const Image<Pixel>&) -> PixelKind { return pixel_kind<Pixel>; },
                    image);
}

/// "8-bit grey", "16-bit RGBA", "float RGB".
std::string to_string(PixelKind kind);

}  // namespace rasterlab

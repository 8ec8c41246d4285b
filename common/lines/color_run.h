// Equal pixels next to each other, written many bytes at a time: what the quick lines and the quick
// triangles are made of.
#pragma once

#include "common/image/pixel.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rasterlab {

/// Fills runs of pixels with one colour. Only the pixels of a run are written; stores overlap
/// instead of ending early, so there are few, and few branches.
class ColorRun {
 public:
  explicit ColorRun(const Rgb8& color) {
    static_assert(std::endian::native == std::endian::little && sizeof(Rgb8) == 3);
    red_first_ =
        (color.r | std::uint64_t{color.g} << 8 | std::uint64_t{color.b} << 16) * 0x1000001000001;
    green_first_ = red_first_ >> 8 | std::uint64_t{color.b} << 56;
    const std::uint64_t blue_first = green_first_ >> 8 | std::uint64_t{color.r} << 56;
    pixels_ = {red_first_, blue_first, green_first_, red_first_, blue_first, green_first_};
  }

  /// Sets `count` pixels from `first` on; none for count ≤ 0.
  void fill(Rgb8* first, std::ptrdiff_t count) const {
    auto* to = reinterpret_cast<std::uint8_t*>(first);
    std::uint8_t* const end = to + 3 * count;
    if (count >= 16) {
      for (; end - to > 48; to += 48) set_16_pixels(to);
      set_16_pixels(end - 48);
    } else if (count >= 6) {
      // 18 to 45 bytes: the first 16, the last 16, and 16 from a pixel between on.
      set_16_bytes(to, 0);
      set_16_bytes(to + (count < 11 ? 0 : 15), 0);
      set_16_bytes(end - 16, 2);
    } else if (count >= 3) {
      std::memcpy(to, &red_first_, 8);
      std::memcpy(end - 8, &green_first_, 8);
    } else if (count > 0) {
      set_pixel(to);
      set_pixel(end - 3);
    }
  }

 private:
  void set_pixel(std::uint8_t* to) const {
    const auto red_green = static_cast<std::uint16_t>(red_first_);
    std::memcpy(to, &red_green, 2);
    to[2] = static_cast<std::uint8_t>(red_first_ >> 16);
  }

  /// From red (phase 0), green (1) or blue (2) on.
  void set_16_bytes(std::uint8_t* to, std::size_t phase) const {
    std::memcpy(to, &pixels_[2 * phase], 16);
  }

  void set_16_pixels(std::uint8_t* to) const {
    for (std::size_t phase = 0; phase < 3; ++phase) set_16_bytes(to + 16 * phase, phase);
  }

  std::uint64_t red_first_;    ///< the colour over and over from red on
  std::uint64_t green_first_;  ///< the same from green on
  alignas(16) std::array<std::uint64_t, 6> pixels_;
};

}  // namespace rasterlab

// A picture held in memory: the container every stage draws into (exercise 01.1).
#pragma once

#include "common/image/check.h"
#include "common/image/huge_pages.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rasterlab {

/// What a pixel is unless said otherwise: zero in every channel, opaque.
template <class Pixel>
Pixel blank_pixel() {
  if constexpr (requires { Pixel::Zero(); }) {
    return Pixel::Zero();  // Eigen leaves Pixel{} uninitialized.
  } else {
    return Pixel{};
  }
}

/// A width × height array of pixels. Row 0 is the top, x grows to the right and y down; rows follow
/// each other without padding. Pixel types: `std::uint8_t` (grey), `Rgb8`, `Rgba8` (pixel.h),
/// `float`, `std::int32_t`; what a file can hold besides: files.h.
template <class Pixel>
class Image {
 public:
  using value_type = Pixel;

  Image() = default;

  /// Every pixel is `fill`. Throws CheckError when a side is negative or the image would exceed
  /// 2^28 pixels.
  Image(int width, int height, const Pixel& fill = blank_pixel<Pixel>())
      : width_(width), height_(height) {
    const std::size_t count = checked_pixel_count(width, height);
    pixels_.reserve(count);
    advise_huge_pages(pixels_.data(), count * sizeof(Pixel));
    pixels_.assign(count, fill);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  bool contains(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height_; }

  /// Pixel (x, y). Outside the image: throws CheckError, whose message gives coordinates and size.
  Pixel& operator()(int x, int y) {
    check_inside(x, y);
    return row(y)[x];
  }
  const Pixel& operator()(int x, int y) const {
    check_inside(x, y);
    return row(y)[x];
  }

  /// The first pixel of row y, unchecked: for inner loops.
  Pixel* row(int y) { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_; }
  const Pixel* row(int y) const { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_; }

  /// All pixels, row after row.
  std::vector<Pixel>& pixels() { return pixels_; }
  const std::vector<Pixel>& pixels() const { return pixels_; }

  void clear(const Pixel& value) { pixels_.assign(pixels_.size(), value); }

  friend bool operator==(const Image& a, const Image& b) = default;

 private:
  void check_inside(int x, int y) const {
    if (!contains(x, y)) throw_outside(x, y, width_, height_);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace rasterlab

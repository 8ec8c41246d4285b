// What drawing costs before a pixel is computed.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rasterlab::bench {

/// The cache lines of 64 bytes that primitives touch, each as often as a primitive comes back to it
/// after another line. Storing one byte in each takes what the machine needs to move them through
/// its caches. A drawing that writes those pixels takes hardly less: a few percent where this reads
/// long lists of lines, and the drawing does not.
class MemoryLimit {
 public:
  explicit MemoryLimit(Image<Rgb8>& image)
      : bytes_(reinterpret_cast<volatile std::uint8_t*>(image.row(0))) {}

  /// Adds `count` pixels of a row from the pixel at `offset` on, counted from the image's first.
  void add(std::ptrdiff_t offset, std::ptrdiff_t count) {
    constexpr std::ptrdiff_t line_size = 64;
    constexpr std::ptrdiff_t pixel_size = sizeof(Rgb8);
    const std::ptrdiff_t first = offset * pixel_size / line_size;
    const std::ptrdiff_t last = (pixel_size * (offset + count) - 1) / line_size;
    for (std::ptrdiff_t line = first; line <= last; ++line) {
      const auto byte = static_cast<std::uint32_t>(line * line_size);
      if (lines_.empty() || lines_.back() != byte) lines_.push_back(byte);
    }
  }

  void operator()() const {
    for (const std::uint32_t byte : lines_) bytes_[byte] = 1;
  }

 private:
  volatile std::uint8_t* bytes_;
  std::vector<std::uint32_t> lines_;
};

}  // namespace rasterlab::bench

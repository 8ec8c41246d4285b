// PBM, PGM, PPM and PFM, written here: what they are is soon said, and OpenCV's codecs are long in
// loading (opencv_library.h).
#include "common/image/formats.h"

#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace rasterlab::formats {
namespace {

std::string header(char format, int width, int height) {
  std::string line = "P";
  line += format;
  return line + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n";
}

/// Numbers as words; rows begin on a new line, and none is longer than the formats ask for.
class TextRaster {
 public:
  explicit TextRaster(std::string& bytes) : bytes_(bytes) {}

  void add(unsigned sample) {
    constexpr std::size_t longest_line = 70;
    const std::string word = std::to_string(sample);
    if (line_length_ + 1 + word.size() > longest_line) end_line();
    if (line_length_ > 0) bytes_ += ' ';
    line_length_ += word.size() + (line_length_ > 0 ? 1 : 0);
    bytes_ += word;
  }
  void end_line() {
    bytes_ += '\n';
    line_length_ = 0;
  }

 private:
  std::string& bytes_;
  std::size_t line_length_ = 0;
};

void append_binary(std::string& bytes, std::uint8_t sample) {
  bytes += static_cast<char>(sample);
}
void append_binary(std::string& bytes, std::uint16_t sample) {
  bytes += static_cast<char>(sample >> 8);
  bytes += static_cast<char>(sample & 255);
}

/// PGM or PPM, by the kind of pixel.
template <class Pixel>
std::string encode_samples(const Image<Pixel>& image, bool text) {
  using Sample =
      std::conditional_t<pixel_kind<Pixel>.depth == Depth::bits8, std::uint8_t, std::uint16_t>;
  constexpr bool grey = pixel_kind<Pixel>.channels == 1;
  std::string bytes =
      header(grey ? (text ? '2' : '5') : (text ? '3' : '6'), image.width(), image.height()) +
      std::to_string(static_cast<Sample>(-1)) + "\n";
  TextRaster raster(bytes);
  for (int y = 0; y < image.height(); ++y) {
    const auto* row = reinterpret_cast<const Sample*>(image.row(y));
    for (int i = 0; i < image.width() * pixel_kind<Pixel>.channels; ++i) {
      if (text) {
        raster.add(row[i]);
      } else {
        append_binary(bytes, row[i]);
      }
    }
    if (text) raster.end_line();
  }
  return bytes;
}

}  // namespace

std::string encode_pbm(const Image<std::uint8_t>& image, bool text) {
  std::string bytes = header(text ? '1' : '4', image.width(), image.height());
  TextRaster raster(bytes);
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* row = image.row(y);
    unsigned packed = 0;
    for (int x = 0; x < image.width(); ++x) {
      const unsigned black = row[x] < 128 ? 1 : 0;
      if (text) raster.add(black);
      packed |= black << (7 - x % 8);
      if (!text && (x % 8 == 7 || x + 1 == image.width())) {
        bytes += static_cast<char>(std::exchange(packed, 0U));
      }
    }
    if (text) raster.end_line();
  }
  return bytes;
}

std::string encode_netpbm(const AnyImage& image, bool text) {
  return std::visit(
      [&]<class Pixel>(const Image<Pixel>& pixels) -> std::string {
        constexpr PixelKind kind = pixel_kind<Pixel>;
        if constexpr (kind.channels == 4 || kind.depth == Depth::floating)
          return {};
        else
          return encode_samples(pixels, text);
      },
      image);
}

std::string encode_pfm(const AnyImage& image) {
  return std::visit(
      [&]<class Pixel>(const Image<Pixel>& pixels) -> std::string {
        if constexpr (pixel_kind<Pixel>.depth != Depth::floating) return {};
        const bool grey = pixel_kind<Pixel>.channels == 1;
        std::string bytes = header(grey ? 'f' : 'F', pixels.width(), pixels.height());
        bytes += std::endian::native == std::endian::little ? "-1\n" : "1\n";
        for (int y = pixels.height() - 1; y >= 0; --y) {  // The bottom row comes first.
          bytes.append(reinterpret_cast<const char*>(pixels.row(y)),
                       static_cast<std::size_t>(pixels.width()) * sizeof(Pixel));
        }
        return bytes;
      },
      image);
}

}  // namespace rasterlab::formats

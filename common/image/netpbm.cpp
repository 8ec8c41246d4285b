// PBM, PGM, PPM (https://netpbm.sourceforge.net/doc/) and PFM. OpenCV reads these too, but takes
// binary samples for 8 or 16 bit whatever the maximum the header gives, refuses text with a maximum
// other than 255 and 65535, and divides PFM by its scale.
#include "common/image/formats.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <type_traits>

namespace rasterlab::formats {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Words and numbers of a header or a text raster; counts lines for its errors.
class Reader {
 public:
  explicit Reader(const Source& source) : source_(source) {}

  /// The next word, white space and comments skipped.
  std::string_view word(const char* expected) {
    skip_to_word();
    const std::size_t begin = position_;
    while (position_ < source_.bytes.size() && !is_space(peek()) && peek() != '#') ++position_;
    if (begin == position_) {
      fail(source_, line() + "the file ends, expected " + expected);
    }
    return source_.bytes.substr(begin, position_ - begin);
  }

  template <class Number>
  Number number(const char* expected) {
    const std::string_view text = word(expected);
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail(source_,
           line() + "found '" + std::string(text.substr(0, 20)) + "', expected " + expected);
    }
    return value;
  }

  /// The next 0 or 1 of a text PBM, whose digits need no space between.
  bool bit() {
    skip_to_word();
    const char c = position_ < source_.bytes.size() ? source_.bytes[position_] : '\0';
    if (c != '0' && c != '1') fail(source_, line() + "expected a pixel, 0 or 1");
    ++position_;
    return c == '1';
  }

  /// What follows a binary format's header: a comment that directly follows it, or one white space.
  std::string_view raster() {
    if (position_ < source_.bytes.size() && peek() == '#') skip_comment();
    if (position_ < source_.bytes.size()) ++position_;
    return rest();
  }

  std::string_view rest() const { return source_.bytes.substr(position_); }
  std::string line() const { return "line " + std::to_string(line_) + ": "; }
  const Source& source() const { return source_; }

 private:
  char peek() const { return source_.bytes[position_]; }

  void skip_comment() {
    while (position_ < source_.bytes.size() && peek() != '\n') ++position_;
  }

  void skip_to_word() {
    while (position_ < source_.bytes.size() && (is_space(peek()) || peek() == '#')) {
      if (peek() == '#') {
        skip_comment();
      } else {
        if (peek() == '\n') ++line_;
        ++position_;
      }
    }
  }

  const Source& source_;
  std::size_t position_ = 0;
  int line_ = 1;
};

struct Header {
  char format = '1';  ///< the digit after P
  int width = 0;
  int height = 0;
  unsigned maximum = 1;

  bool is_text() const { return format <= '3'; }
  bool is_bitmap() const { return format == '1' || format == '4'; }
  unsigned channels() const { return format == '3' || format == '6' ? 3 : 1; }
};

std::pair<int, int> read_size(Reader& reader) {
  const auto width = reader.number<std::int64_t>("the width");
  const auto height = reader.number<std::int64_t>("the height");
  check_size(reader.source(), width, height);
  return {static_cast<int>(width), static_cast<int>(height)};
}

Header read_header(Reader& reader) {
  Header header;
  header.format = reader.word("a magic number")[1];
  std::tie(header.width, header.height) = read_size(reader);
  if (header.is_bitmap()) return header;
  header.maximum = reader.number<unsigned>("the maximum, 1 to 65535");
  if (header.maximum < 1 || header.maximum > 65535) {
    fail(reader.source(), reader.line() + "the maximum is " + std::to_string(header.maximum) +
                              ", expected 1 to 65535");
  }
  return header;
}

/// An image whose samples `next` gives, row after row.
template <class Pixel, class Next>
Image<Pixel> fill(const Header& header, Next next) {
  Image<Pixel> image(header.width, header.height);
  for (Pixel& pixel : image.pixels()) {
    if constexpr (std::is_integral_v<Pixel>) {
      pixel = next();
    } else {
      pixel.r = next();
      pixel.g = next();
      pixel.b = next();
    }
  }
  return image;
}

template <class Sample, class Next>
AnyImage fill_scaled(const Source& source, const Header& header, Next next) {
  constexpr unsigned full = static_cast<Sample>(-1);
  const auto scaled = [&]() -> Sample {
    const unsigned value = next();
    if (value > header.maximum) {
      fail(source, "a sample is " + std::to_string(value) + ", the header says at most " +
                       std::to_string(header.maximum));
    }
    return static_cast<Sample>((value * full + header.maximum / 2) / header.maximum);
  };
  if (header.channels() == 1) return fill<Sample>(header, scaled);
  return fill<std::conditional_t<sizeof(Sample) == 1, Rgb8, Rgb16>>(header, scaled);
}

template <class Next>
AnyImage fill_samples(const Source& source, const Header& header, Next next) {
  if (header.maximum < 256) return fill_scaled<std::uint8_t>(source, header, next);
  return fill_scaled<std::uint16_t>(source, header, next);
}

AnyImage read_text(Reader& reader, const Header& header) {
  const std::uint64_t samples = std::uint64_t{header.channels()} *
                                static_cast<unsigned>(header.width) *
                                static_cast<unsigned>(header.height);
  const bool bitmap = header.is_bitmap();
  check_not_cut_off(reader.source(), reader.rest().size(), bitmap ? samples : 2 * samples);
  if (bitmap) {
    return fill<std::uint8_t>(header,
                              [&] { return reader.bit() ? std::uint8_t{0} : std::uint8_t{255}; });
  }
  return fill_samples(reader.source(), header, [&] { return reader.number<unsigned>("a sample"); });
}

AnyImage read_packed_bits(Reader& reader, const Header& header) {
  const std::string_view raster = reader.raster();
  const std::size_t row_bytes = (static_cast<std::size_t>(header.width) + 7) / 8;
  check_not_cut_off(reader.source(), raster.size(),
                    row_bytes * static_cast<std::size_t>(header.height));
  Image<std::uint8_t> image(header.width, header.height);
  for (int y = 0; y < header.height; ++y) {
    const std::string_view row = raster.substr(static_cast<std::size_t>(y) * row_bytes, row_bytes);
    for (int x = 0; x < header.width; ++x) {
      const bool black = (row[static_cast<std::size_t>(x / 8)] >> (7 - x % 8) & 1) != 0;
      image.row(y)[x] = black ? 0 : 255;
    }
  }
  return image;
}

AnyImage read_binary(Reader& reader, const Header& header) {
  const std::string_view raster = reader.raster();
  const unsigned sample_bytes = header.maximum < 256 ? 1 : 2;
  check_not_cut_off(reader.source(), raster.size(),
                    std::uint64_t{sample_bytes} * header.channels() *
                        static_cast<unsigned>(header.width) * static_cast<unsigned>(header.height));
  auto next = reinterpret_cast<const unsigned char*>(raster.data());
  return fill_samples(reader.source(), header, [&, next]() mutable -> unsigned {
    if (sample_bytes == 1) return *next++;
    next += 2;
    return next[-2] * 256U + next[-1];
  });
}

/// A float as a PFM stores it.
float stored_float(const char* bytes, bool little_endian) {
  std::array<char, sizeof(float)> copy{};
  std::memcpy(copy.data(), bytes, copy.size());
  if (little_endian != (std::endian::native == std::endian::little)) std::ranges::reverse(copy);
  return std::bit_cast<float>(copy);
}

template <class Pixel>
AnyImage read_floats(const Source& source, std::string_view raster, int width, int height,
                     bool little_endian) {
  const std::size_t row_bytes = static_cast<std::size_t>(width) * sizeof(Pixel);
  check_not_cut_off(source, raster.size(), row_bytes * static_cast<std::size_t>(height));
  Image<Pixel> image(width, height);
  const char* next = raster.data();
  for (int y = height - 1; y >= 0; --y) {  // The bottom row comes first.
    auto* row = reinterpret_cast<float*>(image.row(y));
    for (std::size_t i = 0; i < row_bytes / sizeof(float); ++i, next += sizeof(float)) {
      row[i] = stored_float(next, little_endian);
    }
  }
  return image;
}

}  // namespace

AnyImage decode_netpbm(const Source& source) {
  Reader reader(source);
  const Header header = read_header(reader);
  if (header.is_text()) return read_text(reader, header);
  return header.is_bitmap() ? read_packed_bits(reader, header) : read_binary(reader, header);
}

AnyImage decode_pfm(const Source& source) {
  Reader reader(source);
  const bool color = reader.word("a magic number") == "PF";
  const auto [width, height] = read_size(reader);
  const auto scale = reader.number<double>("the scale, negative for little-endian");
  if (!(scale != 0)) fail(source, "the scale is 0, expected a positive or negative number");
  const std::string_view raster = reader.raster();
  return color ? read_floats<Color>(source, raster, width, height, scale < 0)
               : read_floats<float>(source, raster, width, height, scale < 0);
}

}  // namespace rasterlab::formats

// Truevision TGA (TGA File Format Specification 2.0, 1991). Read by our own decoder: stb_image
// takes cut off files for whole, ignores a right-hand origin and the first entry of a colour map,
// and refuses true colour that brings a colour map along.
#include "common/image/convert.h"
#include "common/image/formats.h"
#include "common/image/operations.h"

#include <algorithm>
#include <array>
#include <mutex>

// clang-format off
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
// clang-format on

namespace rasterlab::formats {
namespace {

constexpr std::size_t header_size = 18;

struct Header {
  unsigned id_length;
  bool has_map;
  unsigned type;  ///< 1 colour-mapped, 2 true colour, 3 grey; +8 run-length encoded
  unsigned map_first;
  unsigned map_length;
  unsigned map_bits;
  int width;
  int height;
  unsigned bits;
  unsigned alpha_bits;
  bool right_to_left;
  bool top_to_bottom;

  unsigned plain_type() const { return type & 7U; }
  bool run_length() const { return (type & 8U) != 0; }
  std::size_t pixel_bytes() const { return (bits + 7) / 8; }
  std::size_t map_entry_bytes() const { return has_map ? (map_bits + 7) / 8 : 0; }
};

unsigned byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}
unsigned word_at(std::string_view bytes, std::size_t i) {
  return byte_at(bytes, i) + 256 * byte_at(bytes, i + 1);
}

Header read_header(const Source& source) {
  const std::string_view bytes = source.bytes;
  check_not_cut_off(source, bytes.size(), header_size);
  const unsigned descriptor = byte_at(bytes, 17);
  return {.id_length = byte_at(bytes, 0),
          .has_map = byte_at(bytes, 1) == 1,
          .type = byte_at(bytes, 2),
          .map_first = word_at(bytes, 3),
          .map_length = word_at(bytes, 5),
          .map_bits = byte_at(bytes, 7),
          .width = static_cast<int>(word_at(bytes, 12)),
          .height = static_cast<int>(word_at(bytes, 14)),
          .bits = byte_at(bytes, 16),
          .alpha_bits = descriptor & 15U,
          .right_to_left = (descriptor & 16U) != 0,
          .top_to_bottom = (descriptor & 32U) != 0};
}

bool is_one_of(unsigned value, std::initializer_list<unsigned> values) {
  return std::ranges::find(values, value) != values.end();
}

void check_header(const Source& source, const Header& header) {
  if (!is_one_of(header.type, {1, 2, 3, 9, 10, 11}) || byte_at(source.bytes, 1) > 1) {
    fail(source, "not a TGA file: its type is " + std::to_string(header.type) +
                     ", expected 1, 2, 3, 9, 10 or 11");
  }
  const bool mapped = header.plain_type() == 1;
  const bool depth_is_known = mapped                     ? is_one_of(header.bits, {8, 16})
                              : header.plain_type() == 3 ? is_one_of(header.bits, {8, 16})
                                                         : is_one_of(header.bits, {15, 16, 24, 32});
  if (!depth_is_known) {
    fail(source, "TGA of type " + std::to_string(header.type) + " with " +
                     std::to_string(header.bits) + " bits a pixel, expected " +
                     (header.plain_type() == 2 ? "15, 16, 24 or 32" : "8 or 16"));
  }
  if (mapped && (!header.has_map || header.map_length == 0 ||
                 !is_one_of(header.map_bits, {15, 16, 24, 32}))) {
    fail(source, "colour-mapped TGA without a colour map of 15, 16, 24 or 32 bits an entry");
  }
  check_size(source, header.width, header.height);
}

/// The stored pixels with runs written out. Checks that they are all there before it allocates
/// them.
std::string expand_runs(const Source& source, const Header& header, std::string_view packets) {
  const std::size_t size = header.pixel_bytes();
  const std::size_t needed =
      size * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  const auto walk = [&](auto visit) {
    std::size_t position = 0;
    std::size_t produced = 0;
    while (produced < needed && position < packets.size()) {
      const unsigned head = byte_at(packets, position);
      const std::size_t count = (head & 127U) + 1;
      const bool repeats = head >= 128;
      const std::size_t stored = repeats ? size : size * count;
      if (packets.size() - position - 1 < stored) break;
      visit(packets.substr(position + 1, stored), repeats ? count : 1);
      position += 1 + stored;
      produced += size * count;
    }
    return produced;
  };
  check_not_cut_off(source, walk([](std::string_view, std::size_t) {}), needed);
  std::string pixels;
  pixels.reserve(needed + 128 * size);  // The last packet may run over.
  walk([&](std::string_view packet, std::size_t times) {
    for (; times > 0; --times) pixels += packet;
  });
  return pixels;
}

std::uint8_t from_5_bits(unsigned value) {
  return static_cast<std::uint8_t>((value * 255 + 15) / 31);
}

/// A colour as stored in a pixel or a map entry of 15 to 32 bits. The top bit of 16 is left alone:
/// most files that have one do not mean it as alpha.
Rgba8 color_at(const char* bytes, unsigned bits) {
  const auto stored = reinterpret_cast<const std::uint8_t*>(bytes);
  if (bits <= 16) {
    const unsigned value = stored[0] + 256U * stored[1];
    return {from_5_bits(value >> 10 & 31U), from_5_bits(value >> 5 & 31U), from_5_bits(value & 31U),
            255};
  }
  return {stored[2], stored[1], stored[0], bits == 32 ? stored[3] : std::uint8_t{255}};
}

Rgba8 mapped_color(const Source& source, const Header& header, std::string_view map,
                   const char* pixel) {
  const auto stored = reinterpret_cast<const std::uint8_t*>(pixel);
  const unsigned index = header.bits == 8 ? stored[0] : stored[0] + 256U * stored[1];
  if (index < header.map_first || index - header.map_first >= header.map_length) {
    fail(source, "a pixel is entry " + std::to_string(index) + " of the colour map, which has " +
                     std::to_string(header.map_first) + " to " +
                     std::to_string(header.map_first + header.map_length - 1));
  }
  return color_at(map.data() + (index - header.map_first) * header.map_entry_bytes(),
                  header.map_bits);
}

Rgba8 pixel_color(const Source& source, const Header& header, std::string_view map,
                  const char* pixel) {
  switch (header.plain_type()) {
    case 1:
      return mapped_color(source, header, map, pixel);
    case 2:
      return color_at(pixel, header.bits);
    default: {
      const auto grey = reinterpret_cast<const std::uint8_t*>(pixel);
      return {grey[0], grey[0], grey[0], header.bits == 16 ? grey[1] : std::uint8_t{255}};
    }
  }
}

Image<Rgba8> read_pixels(const Source& source, const Header& header, std::string_view map,
                         std::string_view pixels) {
  Image<Rgba8> image(header.width, header.height);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    image.pixels()[i] = pixel_color(source, header, map, pixels.data() + i * header.pixel_bytes());
  }
  if (header.right_to_left) image = flipped_horizontally(image);
  return header.top_to_bottom ? image : flipped_vertically(image);
}

/// Whether the pixels' fourth channel is an alpha: where the header counts no alpha bits and all
/// are 0, it is only filling.
bool has_alpha(const Header& header, const Image<Rgba8>& image) {
  const unsigned bits = header.plain_type() == 1 ? header.map_bits : header.bits;
  if (bits != 32 && !(header.plain_type() == 3 && bits == 16)) return false;
  return header.alpha_bits > 0 ||
         std::ranges::any_of(image.pixels(), [](const Rgba8& pixel) { return pixel.a != 0; });
}

}  // namespace

AnyImage decode_tga(const Source& source) {
  const Header header = read_header(source);
  check_header(source, header);
  const std::size_t map_begin = header_size + header.id_length;
  const std::size_t map_size = header.map_length * header.map_entry_bytes();
  check_not_cut_off(source, source.bytes.size(), map_begin + map_size);
  const std::string_view map = source.bytes.substr(map_begin, map_size);
  std::string_view pixels = source.bytes.substr(map_begin + map_size);
  std::string expanded;
  if (header.run_length()) {
    expanded = expand_runs(source, header, pixels);
    pixels = expanded;
  }
  check_not_cut_off(source, pixels.size(),
                    header.pixel_bytes() * static_cast<std::size_t>(header.width) *
                        static_cast<std::size_t>(header.height));
  const Image<Rgba8> image = read_pixels(source, header, map, pixels);
  if (has_alpha(header, image)) return image;
  if (header.plain_type() == 3) return convert<std::uint8_t>(image);
  return convert<Rgb8>(image);
}

std::string encode_tga(const AnyImage& image, bool run_length) {
  // Whether stb_image_write packs runs is a variable of its own.
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  stbi_write_tga_with_rle = run_length ? 1 : 0;
  const auto append = [](void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                             static_cast<std::size_t>(size));
  };
  std::string bytes;
  std::visit(
      [&](const auto& pixels) {
        stbi_write_tga_to_func(append, &bytes, pixels.width(), pixels.height(),
                               kind_of(image).channels, pixels.row(0));
      },
      image);
  return bytes;
}

}  // namespace rasterlab::formats

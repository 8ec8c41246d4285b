#include "common/image/animation.h"

#include "common/image/bytes.h"
#include "common/image/check.h"
#include "common/image/formats.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace rasterlab {
namespace {

std::string big_endian_bytes(std::uint32_t value, int count) {
  std::string bytes;
  for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
    bytes += static_cast<char>(value >> shift & 255U);
  }
  return bytes;
}

std::uint32_t big_endian_number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

// The PNG specification's CRC-32 (annex D).
std::uint32_t checksum(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      entries[i] = i;
      for (int bit = 0; bit < 8; ++bit) {
        entries[i] = (entries[i] >> 1) ^ ((entries[i] & 1U) != 0 ? 0xEDB88320U : 0U);
      }
    }
    return entries;
  }();
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc = table[(crc ^ static_cast<unsigned char>(byte)) & 255U] ^ (crc >> 8);
  }
  return ~crc;
}

std::string chunk(std::string_view type, std::string_view content) {
  const std::string body = std::string(type) + std::string(content);
  return big_endian_bytes(static_cast<std::uint32_t>(content.size()), 4) + body +
         big_endian_bytes(checksum(body), 4);
}

constexpr std::size_t signature_length = 8;
constexpr std::size_t chunk_overhead = 12;  // length, type, checksum

}  // namespace

void Animation::add(const Image<Rgb8>& frame) {
  const std::string png = formats::encode_png(frame);
  CompressedFrame compressed;
  for (std::string_view rest = std::string_view(png).substr(signature_length); !rest.empty();) {
    const std::size_t length = big_endian_number(rest);
    const std::string_view type = rest.substr(4, 4);
    const std::string_view content = rest.substr(8, length);
    if (type == "IHDR") compressed.header = content;
    if (type == "IDAT") compressed.pixels += content;
    rest.remove_prefix(length + chunk_overhead);
  }
  if (!frames_.empty() && compressed.header != frames_[0].header) {
    throw CheckError("the frames of an animation must all have the same size");
  }
  frames_.push_back(std::move(compressed));
}

void Animation::write(const std::filesystem::path& path, int milliseconds) const {
  if (frames_.empty()) throw CheckError("an animation needs at least one frame");
  const std::string& header = frames_[0].header;
  std::string file = "\x89PNG\r\n\x1A\n" + chunk("IHDR", header);
  const auto frame_count = static_cast<std::uint32_t>(frames_.size());
  file += chunk("acTL", big_endian_bytes(frame_count, 4) + big_endian_bytes(0, 4));  // 0: forever
  std::uint32_t sequence = 0;
  for (const CompressedFrame& frame : frames_) {
    const std::string size_and_place = header.substr(0, 8) + std::string(8, '\0');
    const std::string delay =
        big_endian_bytes(static_cast<std::uint32_t>(milliseconds), 2) + big_endian_bytes(1000, 2);
    const std::string replace = std::string(2, '\0');  // leaves the frame, and overwrites the last
    file += chunk("fcTL", big_endian_bytes(sequence++, 4) + size_and_place + delay + replace);
    file += &frame == &frames_[0] ? chunk("IDAT", frame.pixels)
                                  : chunk("fdAT", big_endian_bytes(sequence++, 4) + frame.pixels);
  }
  write_file(path, file + chunk("IEND", ""));
}

}  // namespace rasterlab

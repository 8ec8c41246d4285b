// The formats behind files.h, each in a file of its own: bytes to picture and back. Not for use
// outside common/image.
#pragma once

#include "common/image/any_image.h"
#include "common/image/files.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterlab::formats {

/// A file's content and the name that errors give it.
struct Source {
  std::string name;
  std::string_view bytes;
};

/// Throws InputError "NAME: WHAT".
[[noreturn]] void fail(const Source& source, const std::string& what);

/// Throws InputError unless width × height is 1 to 2^28 pixels.
void check_size(const Source& source, std::int64_t width, std::int64_t height);

/// Throws InputError unless at least `needed` bytes are there to hold the pixels: "NAME: cut off…".
void check_not_cut_off(const Source& source, std::uint64_t available, std::uint64_t needed);

AnyImage decode_netpbm(const Source& source);  ///< P1 … P6
AnyImage decode_pfm(const Source& source);
AnyImage decode_png(const Source& source);
AnyImage decode_jpeg(const Source& source);
AnyImage decode_tga(const Source& source);

/// Pixels: 8 bit grey, RGB or RGBA; sides at most 65535.
std::string encode_tga(const AnyImage& image, bool run_length);

/// White from 128.
std::string encode_pbm(const Image<std::uint8_t>& image, bool text);

/// PGM or PPM. Pixels: 8 or 16 bit grey or RGB.
std::string encode_netpbm(const AnyImage& image, bool text);

/// Pixels: float, grey or RGB.
std::string encode_pfm(const AnyImage& image);

/// Pixels: 8 or 16 bit.
std::string encode_png(const AnyImage& image);

/// Pixels: 8 bit grey or RGB; `quality` 0 to 100.
std::string encode_jpeg(const AnyImage& image, int quality);

}  // namespace rasterlab::formats

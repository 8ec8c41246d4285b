// Pictures in files: PNG, JPEG, TGA, PBM/PGM/PPM (text and binary) and PFM, each read and written
// by one function.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>

namespace rasterlab {

/// A picture with the pixels its file stores: grey or colour, with or without alpha, 8 bit, 16 bit
/// or float.
using AnyImage = std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<Rgb8>, Image<Rgb16>,
                              Image<Rgba8>, Image<Rgba16>, Image<float>, Image<Color>>;

/// Reads a picture as it is stored. The format is told by the file's content; TGA, which has no
/// mark of its own, by the extension `.tga`. Row 0 is the top whatever order the file keeps its
/// rows in. Throws InputError when the file cannot be read, is of no known format, is cut off or
/// contradicts itself, or claims more than 2^28 pixels; nothing is allocated that the file's length
/// does not justify.
AnyImage read_any_image(const std::filesystem::path& path);

/// Reads a picture and converts it to `Pixel`, any of AnyImage's, as convert() of operations.h
/// does: a picture that is read as `Rgb8` loses its alpha, one read as `float` is grey, in [0, 1]
/// unless the file holds floats.
template <class Pixel>
Image<Pixel> read_image(const std::filesystem::path& path);

struct WriteOptions {
  bool text = false;       ///< PBM/PGM/PPM: numbers one can read in place of bytes
  bool run_length = true;  ///< TGA: equal neighbours stored once
  int jpeg_quality = 95;   ///< 0…100
};

/// Writes a picture in the format its extension says: .png .jpg .jpeg .tga .pbm .pgm .ppm .pnm
/// .pfm. What the format cannot hold is converted as convert() does: colour to grey for .pgm, alpha
/// dropped for .jpg, 16 bit to 8 for .tga, floats in [0, 1] to 8 bit for all but .pfm. `.pgm`,
/// `.ppm` and `.png` keep 16 bit; `.pfm` keeps infinities. `Pixel` is any of AnyImage's. Throws
/// InputError when the extension is none of these, the picture is empty, or the file cannot be
/// written; then no file is left and an older one of that name is untouched.
template <class Pixel>
void write_image(const std::filesystem::path& path, const Image<Pixel>& image,
                 const WriteOptions& options = {});
void write_image(const std::filesystem::path& path, const AnyImage& image,
                 const WriteOptions& options = {});

/// Makes a file whole or not at all: `write` gets the path of a temporary file beside `path`, of
/// the same extension, which is renamed to `path` when `write` returns and removed when it throws.
/// Where `path` is no ordinary file, as /dev/stdout, `write` gets `path` itself. Throws InputError
/// when `path` is a folder or cannot be written.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// Makes a file of these bytes, whole or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// All bytes of a file. Throws InputError when it does not exist, is a folder or cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace rasterlab

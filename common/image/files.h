// Pictures in files: PNG, JPEG, TGA, PBM/PGM/PPM (text and binary) and PFM, each read and written
// by one function.
#pragma once

#include "common/image/any_image.h"
#include "common/image/bytes.h"

#include <filesystem>

namespace rasterlab {

/// Reads a picture as it is stored. The format is told by the file's content; TGA, which has no
/// mark of its own, by the extension `.tga`. Row 0 is the top whatever order the file keeps its
/// rows in. Throws InputError when the file cannot be read, is of no known format, is cut off or
/// contradicts itself, or claims more than 2^28 pixels; nothing is allocated that the file's length
/// does not justify. (Where a text PBM, PGM or PPM is cut within its last number, no one can tell.)
AnyImage read_any_image(const std::filesystem::path& path);

/// Reads a picture and converts it to `Pixel`, any of AnyImage's, as convert.h says: a picture read
/// as `Rgb8` loses its alpha, one read as `float` is grey, in [0, 1] unless the file holds floats.
template <class Pixel>
Image<Pixel> read_image(const std::filesystem::path& path);

struct WriteOptions {
  bool text = false;       ///< PBM, PGM, PPM: numbers one can read in place of bytes
  bool run_length = true;  ///< TGA: equal neighbours stored once
  int jpeg_quality = 95;   ///< 0…100
};

/// Writes a picture in the format its extension says: .png .jpg .jpeg .tga .pbm .pgm .ppm .pnm
/// .pfm. What the format cannot hold is converted as convert.h says: colour to grey for .pgm, alpha
/// dropped for .jpg, 16 bit to 8 for .tga, floats in [0, 1] to 8 bit for all but .pfm; .pbm is
/// white from 128. .pgm, .ppm and .png keep 16 bit; .pfm keeps infinities. `Pixel` is any of
/// AnyImage's. Throws InputError when the extension is none of these, the picture is empty or too
/// large for the format, or the file cannot be written; then nothing is written, and an older file
/// stays.
template <class Pixel>
void write_image(const std::filesystem::path& path, const Image<Pixel>& image,
                 const WriteOptions& options = {});
void write_image(const std::filesystem::path& path, const AnyImage& image,
                 const WriteOptions& options = {});

}  // namespace rasterlab

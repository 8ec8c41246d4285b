// Pictures one after another in one file that a browser plays.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <filesystem>
#include <string>
#include <vector>

namespace rasterlab {

/// An animated PNG that plays without end (PNG specification, third edition, section 11.3.6: acTL,
/// fcTL, fdAT). Every browser plays it; a viewer that knows only still PNG files shows the first
/// frame. Frames are lossless and kept compressed until they are written.
class Animation {
 public:
  /// Adds a frame. All have the size of the first, else CheckError.
  void add(const Image<Rgb8>& frame);

  /// Writes the file, whole or not at all; each frame stays for `milliseconds`, 1 to 65535. Throws
  /// InputError when it cannot be written, CheckError when there is no frame.
  void write(const std::filesystem::path& path, int milliseconds) const;

 private:
  struct CompressedFrame {
    std::string header;  ///< content of IHDR
    std::string pixels;  ///< content of all IDAT
  };
  std::vector<CompressedFrame> frames_;
};

}  // namespace rasterlab

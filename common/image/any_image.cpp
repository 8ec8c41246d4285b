#include "common/image/any_image.h"

namespace rasterlab {

std::string to_string(PixelKind kind) {
  const char* depth = kind.depth == Depth::bits8    ? "8-bit"
                      : kind.depth == Depth::bits16 ? "16-bit"
                                                    : "float";
  const char* channels = kind.channels == 1 ? " grey" : kind.channels == 3 ? " RGB" : " RGBA";
  return std::string(depth) + channels;
}

}  // namespace rasterlab

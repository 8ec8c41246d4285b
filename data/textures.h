// The textures in data/, as the program that wrote them makes them.
#pragma once

#include "common/image/any_image.h"

#include <string>
#include <vector>

namespace rasterlab {

struct MadeTexture {
  std::string file;  ///< its name in data/
  AnyImage image;
};

/// All of them; the same pixels at every call.
std::vector<MadeTexture> make_textures();

}  // namespace rasterlab

// Reading pictures of any format.
#pragma once

#include "common/image/files.h"

#include "tests/fuzz/fuzz_target.h"

#include <variant>

namespace rasterlab {

/// `extension` tells TGA; other formats are told by their content.
inline void fuzz_picture(std::string_view bytes, const std::string& extension) {
  const AnyImage image = read_any_image(as_file(bytes, extension));
  std::visit(
      [](const auto& pixels) {
        require(pixels.width() > 0 && pixels.height() > 0, "a picture has pixels");
        require(std::int64_t{pixels.width()} * pixels.height() <= std::int64_t{1} << 28U,
                "a picture has at most 2^28 pixels");
      },
      image);
}

}  // namespace rasterlab

// Given: a sequence of pixels into an image.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"

#include <cstdint>

namespace rasterlab {

/// Draws the pixels of a line that are inside the image, whatever line it is, and returns how many
/// they are.
std::int64_t draw_pixels(Image<Rgb8>& image, const LineDiscrete& line, const Rgb8& color);

}  // namespace rasterlab

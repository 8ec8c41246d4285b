// fill_spans() for processors with AVX-512.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

#include <cstdint>

namespace rasterlab {

/// What fill_spans() does; corners beyond ±32768 pixels are left to the plain way. Only where
/// has_avx512().
std::int64_t fill_spans_avx512(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab

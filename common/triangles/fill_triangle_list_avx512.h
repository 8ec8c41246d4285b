// fill_triangle_list() for processors with AVX-512.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fill_triangle_list.h"
#include "common/triangles/fixed_point.h"

#include <span>

namespace rasterlab {

/// What fill_triangle_list() does. Only where has_avx512().
DrawnTriangles fill_triangle_list_avx512(Image<Rgb8>& image, std::span<const Corners> triangles,
                                         const Rgb8& color);

}  // namespace rasterlab

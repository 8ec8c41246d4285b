// draw_line_list() for processors with AVX-512.
#pragma once

#include "common/lines/draw_line_list.h"

namespace rasterlab {

/// What draw_line_list() does, of a list that is worth a pass over the image. Needs two bits a
/// pixel, and more where a side is shorter than 64 pixels. Only where has_avx512().
DrawnLines draw_line_list_avx512(Image<Rgb8>& image, std::span<const Segment> segments,
                                 const Rgb8& color);

}  // namespace rasterlab

#include "common/triangles/fill_spans.h"

#include "common/triangles/spans.h"

#include <algorithm>

namespace rasterlab {

std::int64_t fill_spans(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  std::int64_t pixels = 0;
  for_each_wide_span(corners, image.width(), image.height(), [&](int y, int begin, int end) {
    std::fill(image.row(y) + begin, image.row(y) + end, color);
    pixels += end - begin;
  });
  return pixels;
}

}  // namespace rasterlab

#include "common/triangles/fill_spans.h"

#include "common/lines/color_run.h"
#include "common/triangles/spans.h"

namespace rasterlab {

std::int64_t fill_spans(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const ColorRun span(color);
  Rgb8* const first = image.row(0);
  const std::ptrdiff_t width = image.width();
  std::int64_t pixels = 0;
  for_each_wide_span(corners, image.width(), image.height(),
                     [&span, &pixels, first, width](int y, int begin, int end) {
                       span.fill(first + (y * width + begin), end - begin);
                       pixels += end - begin;
                     });
  return pixels;
}

}  // namespace rasterlab

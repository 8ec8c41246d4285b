#include "common/triangles/fill_spans.h"

#include "common/lines/avx512.h"
#include "common/lines/color_run.h"
#include "common/triangles/fill_spans_avx512.h"
#include "common/triangles/spans.h"

namespace rasterlab {
namespace {

std::int64_t fill_plainly(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
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

}  // namespace

const std::vector<SpanFill>& span_fills() {
  static const std::vector<SpanFill> fills = [] {
    std::vector<SpanFill> possible = {{"plain", &fill_plainly}};
    if (has_avx512()) possible.push_back({"avx512", &fill_spans_avx512});
    return possible;
  }();
  return fills;
}

std::int64_t fill_spans(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  static const auto fill = span_fills().back().fill;
  return fill(image, corners, color);
}

}  // namespace rasterlab

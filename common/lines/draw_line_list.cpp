#include "common/lines/draw_line_list.h"

#include "common/lines/avx512.h"
#include "common/lines/draw_line_list_avx512.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace rasterlab {
namespace {

DrawnLines draw_one_by_one(Image<Rgb8>& image, std::span<const Segment> segments,
                           const Rgb8& color) {
  return draw_line_runs(image, segments, color);
}

/// Whether a list is worth a pass over the image: with half as many pixels. Judged by its first
/// thousand. Marks of a narrow image would take too much memory.
bool is_long(std::span<const Segment> segments, const Image<Rgb8>& image) {
  constexpr int shortest_side = 64;
  const std::span<const Segment> some =
      segments.first(std::min<std::size_t>(segments.size(), 1000));
  std::int64_t pixels = 0;
  for (const auto& [p0, p1] : some) {
    const std::int64_t width = std::abs(std::int64_t{p1.x()} - p0.x());
    const std::int64_t height = std::abs(std::int64_t{p1.y()} - p0.y());
    pixels += std::max(width, height) + 1;
  }
  const std::int64_t pixels_each = pixels / std::max<std::int64_t>(std::ssize(some), 1);
  const std::int64_t image_pixels = std::int64_t{image.width()} * image.height();
  return std::min(image.width(), image.height()) >= shortest_side &&
         2 * pixels_each * std::ssize(segments) > image_pixels;
}

/// Segments of one colour may be drawn in any order, and need not be drawn one by one.
DrawnLines draw_with_avx512(Image<Rgb8>& image, std::span<const Segment> segments,
                            const Rgb8& color) {
  return is_long(segments, image) ? draw_line_list_avx512(image, segments, color)
                                  : draw_line_runs(image, segments, color);
}

}  // namespace

const std::vector<LineListWay>& line_list_ways() {
  static const std::vector<LineListWay> ways = [] {
    std::vector<LineListWay> possible = {{"one by one", &draw_one_by_one}};
    if (has_avx512()) possible.push_back({"avx512", &draw_with_avx512});
    return possible;
  }();
  return ways;
}

DrawnLines draw_line_list(Image<Rgb8>& image, std::span<const Segment> segments,
                          const Rgb8& color) {
  return line_list_ways().back().draw(image, segments, color);
}

}  // namespace rasterlab

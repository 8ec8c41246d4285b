#include "common/lines/draw_line_runs.h"

#include "common/lines/bresenham.h"
#include "common/lines/color_run.h"
#include "common/lines/line_steps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace rasterlab {
// <solution>
namespace {

/// What is to be drawn of a segment from left to right, or from top to bottom where it is steep:
/// steps of its major axis. From pixel to pixel, step k leads ⌊k · minor / major + ½⌋ times across.
struct Walk {
  std::int64_t major = 0;
  std::int64_t minor = 0;
  StepRange visible;
  Rgb8* first = nullptr;      ///< the pixel of the first visible step
  std::ptrdiff_t along = 0;   ///< from a pixel to that of the next step
  std::ptrdiff_t across = 0;  ///< added where the next is in another row, or column where steep
};

constexpr std::uint64_t half = std::uint64_t{1} << 63;

/// The fraction of above / below in 2^-64, rounded down by less than `rounding`; below < 2^32.
///
/// A walk sums up to `major` of them. It then lacks less than major · rounding, and goes right if
/// that is less than the 1 / (2 · major) which the exact sums are apart. So 2^-32 do for lengths to
/// 2^15, and spare a division.
struct Fraction {
  std::uint64_t value;
  std::uint64_t rounding;

  Fraction(std::int64_t above, std::int64_t below, std::int64_t major) {
    const auto divisor = static_cast<std::uint64_t>(below);
    const std::uint64_t scaled = static_cast<std::uint64_t>(above) % divisor << 32;
    value = scaled / divisor << 32;
    rounding = std::uint64_t{1} << 32;
    if (major > 1 << 15) {
      value += (scaled % divisor << 32) / divisor;
      rounding = 1;
    }
  }
};

/// Whether a step leads across cannot be predicted: so there is no branch but the loop's.
void draw_pixel_by_pixel(const Walk& walk, Rgb8 color) {
  const Fraction slope(walk.minor, std::max<std::int64_t>(walk.major, 1), walk.major);
  const bool diagonal = walk.minor == walk.major && walk.minor > 0;
  const std::ptrdiff_t along = walk.along + (diagonal ? walk.across : 0);
  const std::uint64_t step = slope.value + slope.rounding;
  std::uint64_t offset = half + static_cast<std::uint64_t>(walk.visible.first) * step;
  const auto next = [&](Rgb8* pixel) {
    offset += step;
    return pixel + along + (walk.across & -static_cast<std::ptrdiff_t>(offset < step));
  };
  Rgb8* pixel = walk.first;
  std::int64_t pixels = walk.visible.last - walk.visible.first + 1;
  for (; pixels >= 2; pixels -= 2) {
    Rgb8* const second = next(pixel);
    *pixel = color;
    *second = color;
    pixel = next(second);
  }
  if (pixels > 0) *pixel = color;
}

/// For segments that stay in a row for some pixels: row r, 0 ≤ r ≤ minor, ends before step ⌈(r + ½)
/// · major / minor⌉. minor > 0.
void draw_run_by_run(const Walk& walk, Rgb8 color) {
  const ColorRun run(color);
  const auto [first, last] = walk.visible;
  const std::int64_t row = (2 * first * walk.minor + walk.major) / (2 * walk.major);
  const std::int64_t row_end = (2 * row + 1) * walk.major;  // times 2 · minor
  const std::int64_t length = walk.major / walk.minor;
  const Fraction rest_of_length(walk.major, walk.minor, walk.major);
  const Fraction rest_of_end(row_end, 2 * walk.minor, walk.major);
  // From just before the row's end on: what is rounded down again and again is never on it.
  std::uint64_t rest = rest_of_end.value - rest_of_end.rounding;
  std::int64_t end = row_end / (2 * walk.minor) - (rest > rest_of_end.value ? 1 : 0);
  Rgb8* pixel = walk.first;
  for (std::int64_t k = first; k <= last;) {
    const std::int64_t pixels = std::min(end, last) - k + 1;
    run.fill(pixel, pixels);
    k += pixels;
    pixel += pixels + walk.across;
    rest += rest_of_length.value;
    end += length + (rest < rest_of_length.value ? 1 : 0);
  }
}

}  // namespace
// </solution>

std::int64_t draw_line_runs(Image<Rgb8>& image, const Point& p0, const Point& p1,
                            const Rgb8& color) {
  // <solution>
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  const bool steep = std::abs(dy) > std::abs(dx);
  const bool backward = (steep ? dy : dx) < 0;
  const Point& from = backward ? p1 : p0;
  const Point& to = backward ? p0 : p1;
  const std::ptrdiff_t row = image.width();
  Walk walk;
  walk.major = std::max(std::abs(dx), std::abs(dy));
  walk.minor = std::min(std::abs(dx), std::abs(dy));
  walk.along = steep ? row : 1;
  walk.across = steep ? 1 : row;
  if ((dx < 0) != (dy < 0)) walk.across = -walk.across;
  walk.visible = {0, walk.major};
  Point start = from;
  if (!image.contains(p0.x(), p0.y()) || !image.contains(p1.x(), p1.y())) {
    const LineSteps steps(from, to);
    walk.visible = steps.inside(image.width(), image.height());
    if (walk.visible.empty()) return 0;
    start = steps.at(walk.visible.first);
  }
  walk.first = image.row(start.y()) + start.x();
  // Shorter ones are not worth the set-up.
  constexpr std::int64_t shortest_run = 3;
  constexpr std::int64_t shortest_walk = 32;
  if (!steep && walk.minor > 0 &&
      walk.major >= std::max(shortest_run * walk.minor, shortest_walk)) {
    draw_run_by_run(walk, color);
  } else {
    draw_pixel_by_pixel(walk, color);
  }
  return walk.visible.last - walk.visible.first + 1;
  // <starter> std::int64_t drawn = 0;
  // <starter> for (const Point& pixel : line_bresenham(p0, p1)) {
  // <starter>   if (!image.contains(pixel.x(), pixel.y())) continue;
  // <starter>   image(pixel.x(), pixel.y()) = color;
  // <starter>   ++drawn;
  // <starter> }
  // <starter> return drawn;
  // </solution>
}

}  // namespace rasterlab

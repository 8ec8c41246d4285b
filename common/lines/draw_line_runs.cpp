#include "common/lines/draw_line_runs.h"

#include "common/lines/bresenham.h"
#include "common/lines/color_run.h"
#include "common/lines/line_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace rasterlab {
namespace {
// <solution>

/// Where a walk goes from pixel to pixel: a step along the longer side, or one that leads across as
/// well whenever adding `slope` to `offset` carries over from 2^64. Steps are in bytes.
struct Walk {
  std::uint8_t* pixel = nullptr;
  std::int64_t pixels = 0;
  std::ptrdiff_t along = 0;
  std::ptrdiff_t across = 0;
  std::uint64_t offset = 0;
  std::uint64_t slope = 0;
};

/// The next step: `across` where adding `slope` to `offset` carries over, else `along`. That is as
/// good as random, and processors predict half of it wrong: there must be no branch, and compilers
/// make one whatever they are asked.
[[gnu::always_inline]] inline std::ptrdiff_t next_step(std::uint64_t& offset, std::uint64_t slope,
                                                       std::ptrdiff_t along,
                                                       std::ptrdiff_t across) {
  std::ptrdiff_t step = along;
#ifdef __x86_64__
  asm("add %[slope], %[offset]\n\tcmovc %[across], %[step]"
      : [offset] "+&r"(offset), [step] "+r"(step)
      : [slope] "r"(slope), [across] "r"(across)
      : "cc");
#else
  offset += slope;
  if (offset < slope) step = across;
#endif
  return step;
}

[[gnu::always_inline]] inline void draw(const Walk& walk, const Rgb8& color) {
  // In registers, as no pixel that is written can be a part of them.
  const std::array<std::uint8_t, 2> red_green = {color.r, color.g};
  const std::uint8_t blue = color.b;
  std::uint64_t offset = walk.offset;
  std::uint8_t* pixel = walk.pixel;
  const auto draw_and_step = [&] {
    std::memcpy(pixel, red_green.data(), 2);
    pixel[2] = blue;
    pixel += next_step(offset, walk.slope, walk.along, walk.across);
  };
  const auto pixels = static_cast<std::uint64_t>(walk.pixels);
  if (pixels % 2 != 0) draw_and_step();
  for (std::uint64_t pairs = pixels / 2; pairs > 0; --pairs) {
    draw_and_step();
    draw_and_step();
  }
}

constexpr std::uint64_t half = std::uint64_t{1} << 63;

/// Segments of up to so many pixels have slopes in 2^-32, and a quick division.
constexpr std::int64_t longest_quick = 1 << 15;

/// 1 / i in 2^-32, rounded down, and below 1: short segments need no division.
constexpr std::uint64_t below_one = (std::uint64_t{1} << 32) - 1;
constexpr auto reciprocals = [] {
  std::array<std::uint64_t, 64> quotients{};
  for (std::uint64_t i = 1; i < quotients.size(); ++i) quotients[i] = below_one / i;
  return quotients;
}();

/// minor / major in 2^-32, rounded down by at most 2^-32, or by at most `minor` times that where
/// `major` is below 64; and below 1, which it may be equal to.
[[gnu::always_inline]] inline std::uint64_t rounded_down(std::int64_t minor, std::int64_t major) {
  const auto above = static_cast<std::uint64_t>(minor);
  const auto below = static_cast<std::uint64_t>(major);
  if (below < reciprocals.size()) return above * reciprocals[below];
  return std::min((above << 32) / below, below_one);
}

/// Image::contains() with one branch.
bool is_inside(const Image<Rgb8>& image, const Point& p) {
  const bool column = static_cast<unsigned>(p.x()) < static_cast<unsigned>(image.width());
  const bool row = static_cast<unsigned>(p.y()) < static_cast<unsigned>(image.height());
  return column & row;
}

/// A segment with both ends in the image, of at most `longest_quick` pixels, from its left end or,
/// where it is steep, from the upper one: of two pixels equally near the one farther from there is
/// drawn. No branch depends on its direction.
///
/// The place across is the whole part of k · minor / major + ½, which is either whole or 2^-16 at
/// least from being so. Rounded down, the slope takes at most 2^-17 from it along the way, which is
/// added before: too little to matter. So is what takes it from 1 to below 1, where the place is
/// always half a pixel from changing.
[[gnu::always_inline]] inline Walk walk_inside(Image<Rgb8>& image, const Point& p0, std::int64_t dx,
                                               std::int64_t dy) {
  const std::int64_t left = dx >> 63;  // all bits or none
  const std::int64_t up = dy >> 63;
  const std::int64_t width = (dx ^ left) - left;
  const std::int64_t height = (dy ^ up) - up;
  const std::int64_t steep = (width - height) >> 63;
  const std::ptrdiff_t pixel = sizeof(Rgb8);
  const std::ptrdiff_t row = image.width() * pixel;
  const std::ptrdiff_t exchange_steps = (pixel ^ row) & steep;
  const std::int64_t exchange_sides = (width ^ height) & steep;
  const std::int64_t major = width ^ exchange_sides;
  const std::int64_t minor = height ^ exchange_sides;
  const std::int64_t rising = left ^ up;
  const std::int64_t backward = (rising & steep) ^ left;
  const std::ptrdiff_t start_x = p0.x() + (dx & backward);
  const std::ptrdiff_t start_y = p0.y() + (dy & backward);
  Walk walk;
  walk.pixel = reinterpret_cast<std::uint8_t*>(image.row(0)) + (start_y * row + start_x * pixel);
  walk.pixels = major + 1;
  walk.along = pixel ^ exchange_steps;
  walk.across = walk.along + ((row ^ exchange_steps ^ rising) - rising);
  walk.slope = rounded_down(minor, major) << 32;
  walk.offset = half + (half >> 16);
  return walk;
}

/// Whether rows are so long that they are better written as a whole.
bool has_long_runs(std::int64_t dx, std::int64_t dy, std::int64_t pixels) {
  constexpr std::int64_t shortest_run = 6;
  constexpr std::int64_t shortest_segment = 32;
  return pixels > shortest_segment && std::abs(dx) >= shortest_run * std::abs(dy);
}

/// What is to be seen of a segment: steps of its longer side, from the left or, where it is steep,
/// from the top. In step k it is ⌊k · minor / major + ½⌋ pixels across.
struct VisibleSteps {
  std::int64_t major = 0;
  std::int64_t minor = 0;
  StepRange range;
  Rgb8* first = nullptr;
  std::ptrdiff_t along = 0;   ///< in pixels
  std::ptrdiff_t across = 0;  ///< in pixels

  bool has_long_runs() const {
    return along == 1 && rasterlab::has_long_runs(major, minor, major + 1);
  }
  std::int64_t count() const { return range.empty() ? 0 : range.last - range.first + 1; }
};

VisibleSteps visible_steps(Image<Rgb8>& image, const Point& p0, const Point& p1) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  const bool steep = std::abs(dy) > std::abs(dx);
  const bool backward = (steep ? dy : dx) < 0;
  const LineSteps steps(backward ? p1 : p0, backward ? p0 : p1);
  VisibleSteps visible;
  visible.range = steps.inside(image.width(), image.height());
  if (visible.range.empty()) return visible;
  visible.major = std::max(std::abs(dx), std::abs(dy));
  visible.minor = std::min(std::abs(dx), std::abs(dy));
  visible.along = steep ? image.width() : 1;
  visible.across = steep ? 1 : image.width();
  if ((dx < 0) != (dy < 0)) visible.across = -visible.across;
  const Point start = steps.at(visible.range.first);
  visible.first = image.row(start.y()) + start.x();
  return visible;
}

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
    if (major > longest_quick) {
      value += (scaled % divisor << 32) / divisor;
      rounding = 1;
    }
  }
};

void draw_pixel_by_pixel(const VisibleSteps& steps, const Rgb8& color) {
  const Fraction slope(steps.minor, std::max<std::int64_t>(steps.major, 1), steps.major);
  const bool diagonal = steps.minor == steps.major && steps.minor > 0;
  const std::ptrdiff_t pixel = sizeof(Rgb8);
  Walk walk;
  walk.pixel = reinterpret_cast<std::uint8_t*>(steps.first);
  walk.pixels = steps.count();
  walk.across = (steps.along + steps.across) * pixel;
  walk.along = diagonal ? walk.across : steps.along * pixel;
  walk.slope = slope.value + slope.rounding;
  walk.offset = half + static_cast<std::uint64_t>(steps.range.first) * walk.slope;
  draw(walk, color);
}

/// Row r, 0 ≤ r ≤ minor, ends before step ⌈(r + ½) · major / minor⌉. For what is not steep, and
/// minor > 0.
void draw_run_by_run(const VisibleSteps& steps, const Rgb8& color) {
  const ColorRun run(color);
  const auto [first, last] = steps.range;
  const std::int64_t row = (2 * first * steps.minor + steps.major) / (2 * steps.major);
  const std::int64_t row_end = (2 * row + 1) * steps.major;  // times 2 · minor
  const std::int64_t length = steps.major / steps.minor;
  const Fraction rest_of_length(steps.major, steps.minor, steps.major);
  const Fraction rest_of_end(row_end, 2 * steps.minor, steps.major);
  // From just before the row's end on: what is rounded down again and again is never on it.
  std::uint64_t rest = rest_of_end.value - rest_of_end.rounding;
  std::int64_t end = row_end / (2 * steps.minor) - (rest > rest_of_end.value ? 1 : 0);
  Rgb8* pixel = steps.first;
  for (std::int64_t k = first; k <= last;) {
    const std::int64_t pixels = std::min(end, last) - k + 1;
    run.fill(pixel, pixels);
    k += pixels;
    pixel += pixels + steps.across;
    rest += rest_of_length.value;
    end += length + (rest < rest_of_length.value ? 1 : 0);
  }
}

/// Apart from what is quick, which then needs no stack.
[[gnu::noinline]] std::int64_t draw_what_is_inside(Image<Rgb8>& image, const Point& p0,
                                                   const Point& p1, const Rgb8& color) {
  const VisibleSteps steps = visible_steps(image, p0, p1);
  if (steps.range.empty()) return 0;
  if (!steps.has_long_runs()) {
    draw_pixel_by_pixel(steps, color);
  } else if (steps.minor > 0) {
    draw_run_by_run(steps, color);
  } else {
    ColorRun(color).fill(steps.first, steps.count());
  }
  return steps.count();
}

// </solution>

/// Part of its callers: a call takes a fifth of the time of ten pixels.
[[gnu::always_inline]] inline std::int64_t draw_runs(Image<Rgb8>& image, const Point& p0,
                                                     const Point& p1, const Rgb8& color) {
  // <solution>
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  if (!is_inside(image, p0) || !is_inside(image, p1))
    return draw_what_is_inside(image, p0, p1, color);
  const Walk walk = walk_inside(image, p0, dx, dy);
  if (walk.pixels > longest_quick || has_long_runs(dx, dy, walk.pixels))
    return draw_what_is_inside(image, p0, p1, color);
  draw(walk, color);
  return walk.pixels;
  // <starter> std::int64_t drawn = 0;
  // <starter> for (const Point& pixel : line_bresenham(p0, p1)) {
  // <starter>   if (!image.contains(pixel.x(), pixel.y())) continue;
  // <starter>   image(pixel.x(), pixel.y()) = color;
  // <starter>   ++drawn;
  // <starter> }
  // <starter> return drawn;
  // </solution>
}

}  // namespace

std::int64_t draw_line_runs(Image<Rgb8>& image, const Point& p0, const Point& p1,
                            const Rgb8& color) {
  return draw_runs(image, p0, p1, color);
}

DrawnLines draw_line_runs(Image<Rgb8>& image, std::span<const Segment> segments,
                          const Rgb8& color) {
  DrawnLines drawn;
  for (const auto& [p0, p1] : segments) drawn.add(draw_runs(image, p0, p1, color));
  return drawn;
}

}  // namespace rasterlab

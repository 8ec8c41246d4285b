// The last rung of exercise 01.5 made quick: given, for stages and benchmarks.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/segment.h"

#include <cstdint>
#include <span>

namespace rasterlab {

/// Draws the pixels of line_bresenham(p0, p1) that are inside the image, exactly those, straight
/// into it; of two equally near pixels the one that the finished line_bresenham() takes. Returns
/// how many. Coordinates to ±2^30; throws CheckError beyond. Cost: what is outside the image costs
/// nothing.
std::int64_t draw_line_runs(Image<Rgb8>& image, const Point& p0, const Point& p1,
                            const Rgb8& color);

/// What was drawn of several segments.
struct DrawnLines {
  std::int64_t pixels = 0;  ///< inside the image; one that several segments share counts for each
  std::int64_t lines = 0;   ///< segments that have such pixels

  void add(std::int64_t pixels_of_a_line) {
    pixels += pixels_of_a_line;
    lines += pixels_of_a_line > 0 ? 1 : 0;
  }

  friend bool operator==(const DrawnLines&, const DrawnLines&) = default;
};

/// The same of several, one by one.
DrawnLines draw_line_runs(Image<Rgb8>& image, std::span<const Segment> segments, const Rgb8& color);

}  // namespace rasterlab

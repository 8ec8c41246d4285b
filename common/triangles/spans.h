// Which pixels of each row a triangle covers, without asking every pixel.
//
// The top-left rule says: a row belongs to the triangle when its centre is at or below the top
// corner and above the bottom corner, and in that row the pixels whose centres are at or to the
// right of the left side and left of the right side. So both sides are rounded alike: up to the
// next centre.
#pragma once

#include "common/triangles/edge_function.h"
#include "common/triangles/fixed_point.h"

#include <algorithm>
#include <cstdint>

namespace rasterlab {

/// The first row whose centre is at or below y, within 0 … height.
inline int first_row(std::int64_t y, int height) {
  return static_cast<int>(std::clamp<std::int64_t>((y + subpixels / 2 - 1) >> 8, 0, height));
}

/// A corner as one integer, y above x, so that corners sort from the top down without branches,
/// which no processor could predict. For coordinates below 2^31.
inline std::int64_t pack(const SnappedPoint& corner) {
  return corner.y() * (std::int64_t{1} << 32) + corner.x();
}
inline void sort_two(std::int64_t& a, std::int64_t& b) {
  const std::int64_t swap = b < a ? a ^ b : 0;
  a ^= swap;
  b ^= swap;
}
inline std::int64_t packed_x(std::int64_t corner) {
  return static_cast<std::int32_t>(corner);
}
inline std::int64_t packed_y(std::int64_t corner) {
  return (corner - packed_x(corner)) >> 32;
}

/// A side of a triangle, followed from row to row: where it is, to the first pixel whose centre is
/// not left of it. Exact for corners within ±32768 pixels.
///
/// That pixel is ⌈x − ½⌉, where x is a fraction with a denominator of at most 2^24 units of 1/256
/// pixel. So x − ½, unless whole, is at least 2^-32 above the whole number below it, and may be
/// lowered by less than that before it is rounded up: by 2^-34 here, which leaves room for errors
/// below 2^-34. Where a walk starts, x is computed in doubles with five roundings, each below 2^-37
/// as x and its parts stay below 2^16; a step is a double's rounding of the slope, below 2^-37 over
/// any walk, cut to a multiple of 2^-44, below 2^-36 over 256 rows.
class TriangleSide {
 public:
  /// Longer walks would not be exact.
  static constexpr int longest_walk = 256;

  /// From packed corner `a` down to `b`.
  TriangleSide(std::int64_t a, std::int64_t b)
      : x_(static_cast<double>(packed_x(a))),
        y_(packed_y(a)),
        slope_(static_cast<double>(packed_x(b) - packed_x(a)) /
               static_cast<double>(std::max<std::int64_t>(packed_y(b) - packed_y(a), 1))) {}

  /// The side in a row whose centre is between its ends.
  std::int64_t at_row(int row) const {
    const std::int64_t down = row * subpixels + subpixels / 2 - y_;
    const double x = x_ + static_cast<double>(down) * slope_;
    // ⌈x − ½⌉ = ⌊x + ½⌋ once x has been lowered.
    return static_cast<std::int64_t>(x * (one / subpixels) + (0.5 - 0x1p-34) * one);
  }

  /// From one row to the next. A side that is flatter than the clamp has no next row.
  std::int64_t step() const {
    return static_cast<std::int64_t>(std::clamp(slope_, -0x1p17, 0x1p17) * one);
  }

  static int pixel(std::int64_t position) { return static_cast<int>(position >> fraction_bits); }

 private:
  static constexpr int fraction_bits = 44;
  static constexpr double one = 0x1p44;

  double x_;
  std::int64_t y_;
  double slope_;  ///< to the right per row, in pixels
};

/// Calls `visit(y, begin, end)` for every row of a width × height image in which the triangle
/// covers a pixel, from the top down: it covers exactly the pixels begin ≤ x < end of that row. For
/// corners within ±32768 pixels.
template <class Visit>
void for_each_span(const SnappedTriangle& corners, int width, int height, Visit&& visit) {
  std::int64_t top = pack(corners[0]);
  std::int64_t middle = pack(corners[1]);
  std::int64_t bottom = pack(corners[2]);
  sort_two(top, middle);
  sort_two(middle, bottom);
  sort_two(top, middle);
  const int turn = first_row(packed_y(middle), height);
  const int last = first_row(packed_y(bottom), height);
  const TriangleSide whole(top, bottom);
  const TriangleSide upper(top, middle);
  const TriangleSide lower(middle, bottom);
  const auto along = [top](std::int64_t corner) {
    return SnappedPoint(packed_x(corner) - packed_x(top), packed_y(corner) - packed_y(top));
  };
  const bool middle_is_left =
      along(middle).x() * along(bottom).y() < along(bottom).x() * along(middle).y();
  for (int y = first_row(packed_y(top), height); y < last;) {
    const TriangleSide& half = y < turn ? upper : lower;
    const int stop = std::min(y < turn ? turn : last, y + TriangleSide::longest_walk);
    const TriangleSide& left_side = middle_is_left ? half : whole;
    const TriangleSide& right_side = middle_is_left ? whole : half;
    const std::int64_t left_step = left_side.step();
    const std::int64_t right_step = right_side.step();
    std::int64_t left = left_side.at_row(y);
    std::int64_t right = right_side.at_row(y);
    for (; y < stop; ++y, left += left_step, right += right_step) {
      const int begin = std::max(TriangleSide::pixel(left), 0);
      const int end = std::min(TriangleSide::pixel(right), width);
      if (begin < end) visit(y, begin, end);
    }
  }
}

/// The same in 128-bit integers, for corners within ±2^30 pixels: each row solved from the three
/// edge functions.
template <class Visit>
void for_each_span_in_128_bits(const SnappedTriangle& corners, int width, int height,
                               Visit&& visit) {
  const auto triangle = make_edges<Int128>(corners);
  if (triangle.twice_area == 0) return;
  const auto divide_up = [](Int128 a, Int128 b) { return a / b + (a % b > 0 ? 1 : 0); };  // b > 0
  const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  for (int y = first_row(top, height); y < first_row(bottom, height); ++y) {
    Int128 begin = 0;
    Int128 end = width;
    for (const auto& edge : triangle.edges) {
      // The edge's side in this row is step_x · x ≥ need.
      const Int128 need = edge.threshold() - edge.at(0, y);
      if (edge.step_x > 0) {
        begin = std::max(begin, divide_up(need, edge.step_x));
      } else if (edge.step_x < 0) {
        end = std::min(end, divide_up(1 - need, -edge.step_x));
      } else if (need > 0) {
        end = 0;
      }
    }
    if (begin < end) visit(y, static_cast<int>(begin), static_cast<int>(end));
  }
}

/// The same of a triangle in pixels, wherever it is within ±2^30. Throws CheckError beyond.
template <class Visit>
void for_each_wide_span(const Corners& corners, int width, int height, Visit&& visit) {
  if (within(corners, max_coordinate)) {
    for_each_span(snap_unchecked(corners), width, height, visit);
  } else {
    for_each_span_in_128_bits(snap(corners, max_wide_coordinate), width, height, visit);
  }
}

}  // namespace rasterlab

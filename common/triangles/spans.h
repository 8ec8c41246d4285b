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
#include <utility>

namespace rasterlab {

/// The first row whose centre is at or below y, within 0 … height.
inline int first_row(std::int64_t y, int height) {
  return static_cast<int>(std::clamp<std::int64_t>((y + subpixels / 2 - 1) >> 8, 0, height));
}

/// A side of a triangle, asked row by row for the first pixel whose centre is not left of it; exact
/// for corners within ±32768 pixels.
///
/// That pixel is ⌈x − ½⌉, where x is a fraction with a denominator of at most 2^24 units of 1/256
/// pixel. So x − ½, unless whole, is at least 2^-32 above the whole number below it, and may be
/// lowered by less than that before it is rounded up. Computed in doubles, values stay below 2^17
/// and the seven roundings below 2^-37 each, together less than 2^-34: lowering by 2^-34 makes the
/// error negative and keeps it under 2^-33.
class TriangleSide {
 public:
  /// `a` is above `b`, and `row` is the first row asked for: between them, or none is asked for.
  TriangleSide(const SnappedPoint& a, const SnappedPoint& b, int row) {
    constexpr double pixel = 1.0 / subpixels;
    slope_ = static_cast<double>(b.x() - a.x()) /
             static_cast<double>(std::max<std::int64_t>(b.y() - a.y(), 1));
    const std::int64_t down = row * subpixels + subpixels / 2 - a.y();
    // ⌈x − ½⌉ = ⌊x + ½⌋ once x has been lowered; offset, so that cutting to an integer is rounding
    // down.
    constexpr double rounding = offset + 0.5 - 0x1p-34;
    x_ = (static_cast<double>(a.x()) * pixel + static_cast<double>(down) * pixel * slope_) +
         rounding;
  }

  /// `rows` below the first.
  int first_pixel(int rows) const { return static_cast<int>(x_ + rows * slope_) - offset; }

 private:
  static constexpr int offset = 1 << 16;

  double slope_ = 0;  ///< in pixels to the right per row
  double x_ = 0;
};

/// Calls `visit(y, begin, end)` for every row of a width × height image in which the triangle
/// covers a pixel, from the top down: it covers exactly the pixels begin ≤ x < end of that row. For
/// corners within ±32768 pixels.
template <class Visit>
void for_each_span(const SnappedTriangle& corners, int width, int height, Visit&& visit) {
  const SnappedPoint* top = &corners[0];
  const SnappedPoint* middle = &corners[1];
  const SnappedPoint* bottom = &corners[2];
  if (middle->y() < top->y()) std::swap(middle, top);
  if (bottom->y() < middle->y()) std::swap(bottom, middle);
  if (middle->y() < top->y()) std::swap(middle, top);
  const int first = first_row(top->y(), height);
  const int turn = first_row(middle->y(), height);
  const int last = first_row(bottom->y(), height);
  const TriangleSide whole(*top, *bottom, first);
  const auto visit_rows = [&](const TriangleSide& side, int from, int to) {
    for (int y = from; y < to; ++y) {
      const int a = whole.first_pixel(y - first);
      const int b = side.first_pixel(y - from);
      const int begin = std::max(std::min(a, b), 0);
      const int end = std::min(std::max(a, b), width);
      if (begin < end) visit(y, begin, end);
    }
  };
  visit_rows(TriangleSide(*top, *middle, first), first, turn);
  visit_rows(TriangleSide(*middle, *bottom, turn), turn, last);
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
  const SnappedTriangle snapped = snap(corners, max_wide_coordinate);
  if (within(corners, max_coordinate)) {
    for_each_span(snapped, width, height, visit);
  } else {
    for_each_span_in_128_bits(snapped, width, height, visit);
  }
}

}  // namespace rasterlab

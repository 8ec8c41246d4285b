// A segment as steps along its longer side, each of which can be asked for by itself: how lines
// that reach far outside an image are clipped without walking there, and without moving a pixel of
// what remains.
#pragma once

#include "common/lines/line_discrete.h"

#include <cstdint>
#include <limits>

namespace rasterlab {

/// Steps first ≤ k ≤ last of a segment; none when first > last.
struct StepRange {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();

  bool empty() const { return first > last; }
};

/// The steps that are in both.
StepRange intersection(const StepRange& a, const StepRange& b);

/// The segment from p0 to p1 goes max(|dx|, |dy|) steps along its *major* axis, the longer of the
/// two; step 0 is p0, the last is p1. In step k the other, *minor* coordinate is the one nearest to
/// the ideal segment; where two are equally near, the one farther from p0.
class LineSteps {
 public:
  /// Throws CheckError when a coordinate is beyond ±2^30.
  LineSteps(const Point& p0, const Point& p1);

  std::int64_t last() const { return major_length_; }

  /// The pixel of step k, 0 ≤ k ≤ last().
  Point at(std::int64_t k) const;

  /// The steps whose pixel has low ≤ y ≤ high.
  StepRange in_rows(std::int64_t low, std::int64_t high) const { return along(1, low, high); }

  /// The steps whose pixel is inside a width × height image, or beside it by at most `border`
  /// pixels: with 1, all that have a pixel inside where a line takes the other of two equally near
  /// ones.
  StepRange inside(int width, int height, int border = 0) const {
    return intersection(along(0, -border, width - 1 + border),
                        along(1, -border, height - 1 + border));
  }

 private:
  StepRange along(int axis, std::int64_t low, std::int64_t high) const;
  std::int64_t first_step_with_offset(std::int64_t offset) const;

  Point start_;
  int major_axis_ = 0;  ///< 0: x, 1: y
  std::int64_t major_length_ = 0;
  std::int64_t minor_length_ = 0;
  int major_direction_ = 1;
  int minor_direction_ = 1;
};

}  // namespace rasterlab

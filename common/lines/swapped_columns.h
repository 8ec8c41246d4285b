// Exercise 01.5, fourth rung: every direction turned into one.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// A segment turned so that it goes to the right and is not steep: from.x ≤ to.x and |dy| ≤ |dx|.
struct TurnedSegment {
  Point from;
  Point to;
  bool transposed = false;  ///< x and y have changed places

  /// The pixel of the segment as it was given.
  Point turned_back(int x, int y) const { return transposed ? Point(y, x) : Point(x, y); }
};

/// Where |dy| > |dx| every point's x and y change places; then, where it goes to the left, the ends
/// do. Coordinates to ±2^30.
TurnedSegment turn(const Point& p0, const Point& p1);

/// The third rung (column_steps.h) of the turned segment, each pixel turned back: one pixel for
/// every column, or for every row where the segment is steep. Pixels come in the order of the
/// growing column or row, whichever end was given first.
///
/// Known fault: up to a pixel off, since y is cut and not rounded.
///
/// Source: B.line, third attempt.
LineDiscrete line_swapped_columns(const Point& p0, const Point& p1);

}  // namespace rasterlab

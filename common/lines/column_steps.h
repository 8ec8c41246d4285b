// Exercise 01.5, third rung: as many pixels as there are columns.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// One pixel for every column x from p0.x to p1.x, growing: y = (1 − t) p0.y + t p1.y, cut to an
/// integer towards 0, where t = (x − p0.x) / (p1.x − p0.x); t = 0 when there is a single column.
/// Where p1.x < p0.x there is no pixel.
///
/// Known faults: gaps where the segment is steep, nothing where it goes from right to left, up to a
/// pixel off. Coordinates to ±2^30.
///
/// Source: B.line, second attempt.
LineDiscrete line_column_steps(const Point& p0, const Point& p1);

}  // namespace rasterlab

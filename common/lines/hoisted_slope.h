// Exercise 01.5, fifth rung: an addition in place of a division.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// As the fourth rung (swapped_columns.h), but the slope dy / dx is computed once, before the loop,
/// and added to y from column to column. Slope and y are `float`; y is cut to an integer where a
/// pixel is drawn.
///
/// Known faults: up to a pixel off, and the rounding of every addition adds up: long segments miss
/// their end, and far from the origin a float has no room for the slope. Coordinates to ±2^30.
///
/// Source: B.line, "optimization".
LineDiscrete line_hoisted_slope(const Point& p0, const Point& p1);

}  // namespace rasterlab

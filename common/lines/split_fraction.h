// Exercise 01.5, sixth rung: the row and how far off it is, kept apart.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// As the fifth rung (hoisted_slope.h), but y is split into an integer, the row, and a `float`, how
/// far the ideal segment is from the middle of that row. |slope| is added to the fraction from
/// column to column; when it exceeds ½, the row moves by one towards the end and the fraction
/// loses 1. So pixels are the nearest, not the next lower.
///
/// Known fault: the fraction's rounding errors still add up, which shows in segments of some
/// thousand pixels. Coordinates to ±2^30.
///
/// Source: B.line, "optimization".
LineDiscrete line_split_fraction(const Point& p0, const Point& p1);

}  // namespace rasterlab

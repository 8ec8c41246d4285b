// Exercise 01.5, last rung: integers alone.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// The pixels that stand for the segment from p0 to p1, both included: one for every column, or for
/// every row where the segment is steep (|dy| > |dx|), each the nearest to the ideal segment. So
/// its distance from the ideal segment along the minor axis is at most ½, neighbours in the
/// sequence touch at a side or a corner, and no pixel comes twice. Only integers are computed with,
/// so this holds for any length.
///
/// Free: where two pixels are equally near, either; the order is from one end to the other,
/// whichever is first. Here pixels come from left to right, or from top to bottom where the segment
/// is steep, and of two equally near pixels the one farther along the minor axis from that start is
/// drawn, so the same pixels are drawn when the ends change places.
///
/// p0 = p1 is one pixel. Coordinates to ±2^30: differences take 64 bits. Cost: one step per pixel.
///
/// Trap: the slides' last version steps before it plots, and draws (0,1) … (10,11) for
/// (0,0)–(10,10).
///
/// Source: B.line; J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM
/// Systems Journal 4(1), 1965.
LineDiscrete line_bresenham(const Point& p0, const Point& p1);

}  // namespace rasterlab

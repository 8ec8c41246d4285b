// Exercise 01.6: Bresenham's algorithm where it is simplest.
#pragma once

#include "common/lines/line_discrete.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

/// The pixels of a segment in the first octant, 0 ≤ p1.y − p0.y ≤ p1.x − p0.x, from p0 to p1: one
/// for every column, in the row nearest to the ideal segment; in integers alone. With `steps`, only
/// those from step `steps.first` to `steps.last`, step 0 being p0: exactly the pixels the whole
/// segment has there, at a cost that does not depend on how far p0 is.
///
/// Free: where two rows are equally near, either; here the one farther from p0. But a part of a
/// segment must have the pixels the whole has.
///
/// p0 = p1 is one pixel; no steps, or steps beyond the segment, are none. Coordinates to ±2^30: 2 ·
/// steps · rows takes all 64 bits. Throws CheckError when the segment is not in the first octant.
/// Cost: one addition and one comparison per pixel.
///
/// Example: (5,5)–(12,9) is (5,5)(6,6)(7,6)(8,7)(9,7)(10,8)(11,8)(12,9).
///
/// Source: A.Q10, A.Q11; Bresenham 1965.
LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps = {});

}  // namespace rasterlab

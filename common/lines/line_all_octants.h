// Exercise 01.8, second part: any segment by way of the first octant.
#pragma once

#include "common/lines/line_discrete.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

/// The pixels of the segment from p0 to p1, in that order: both ends are turned into the first
/// octant, drawn there (bresenham_first_octant.h), and every pixel is turned back. With `steps`,
/// only those steps; step 0 is p0.
///
/// Every pixel is within ½ of the ideal segment along the minor axis, neighbours touch, none comes
/// twice. The set of pixels need *not* be the same when the ends change places, because of two
/// equally near pixels the one farther from p0 is drawn: of the 41 × 41 segments from (0,0) to a
/// pixel within ±20, 592 differ.
///
/// p0 = p1 is one pixel. Coordinates to ±2^30. Cost: one step per pixel.
///
/// Source: A.Q16.
LineDiscrete line_all_octants(const Point& p0, const Point& p1, const StepRange& steps = {});

}  // namespace rasterlab

// Exercise 01.5, the first two rungs: as many steps whatever the length.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// For t = 0, .01, .02, … .99: the pixel that the point p0 + t (p1 − p0) falls into when its
/// coordinates are cut to integers, towards 0. The sequence has 100 pixels, in the order of t,
/// repetitions included.
///
/// Known faults: repeats pixels where the segment is shorter than 100 steps, leaves gaps where it
/// is longer, never draws p1, and lies up to a pixel off. This is the contract of a rung, not an
/// advice.
///
/// Source: B.line, first attempt.
LineDiscrete line_hundred_steps(const Point& p0, const Point& p1);

/// The same for t = 0, .1, … .9: ten pixels.
///
/// Source: B.line, first attempt.
LineDiscrete line_ten_steps(const Point& p0, const Point& p1);

}  // namespace rasterlab

// Exercise 01.8, first part: eight directions by the symmetries of one.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

/// In which octant the segment goes from p0 to p1: 1 from the x axis to the diagonal (0 ≤ dy ≤ dx),
/// and on by 45° each in the sense from +x to +y, to 8 (0 ≤ −dy ≤ dx).
///
/// Free: on a border either of its two octants; any for p0 = p1. Coordinates to ±2^30; differences
/// take 64 bits.
///
/// Source: A.Q13.
int octant_number(const Point& p0, const Point& p1);

/// The symmetry of the plane about the origin, by which segments in octant 1…8 become segments in
/// the first: a swap of x and y, changes of sign, or both. Throws CheckError for any other octant.
///
/// Free: nothing: exactly one symmetry turns a given octant into the first.
///
/// Source: A.Q14.
Point symmetry_octant(const Point& point, int octant);

/// What undoes symmetry_octant(): symmetry_octant_inverse(symmetry_octant(p, o), o) = p. Throws
/// CheckError for an octant other than 1…8.
///
/// Source: A.Q15.
Point symmetry_octant_inverse(const Point& point, int octant);

}  // namespace rasterlab

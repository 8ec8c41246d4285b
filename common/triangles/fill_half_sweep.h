// Exercise 02.4, a rung: one angle of the triangle.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// Every corner is the pixel it falls into; they are sorted from top to bottom. In each row from
/// the top corner's to the middle corner's, the pixels between the two sides that leave the top
/// corner, both ends included, where a side's x is cut to an integer towards 0. A side without
/// height reaches to its farther end.
///
/// Known faults: everything below the middle corner is missing; sides are drawn by both triangles
/// that share them. Corners to ±2^30; throws CheckError beyond.
///
/// Source: B.sweep, first step.
void fill_half_sweep(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab

// Exercise 02.4, a rung: the whole triangle in two sweeps.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/line_discrete.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// Draws the pixels of row y between two sides of a triangle, both included, as far as they are
/// inside the image. A side's x in the row is interpolated between its ends and cut to an integer
/// towards 0; where the ends are in one row, the side reaches from one to the other.
void sweep_row(Image<Rgb8>& image, int y, const std::array<Point, 2>& side,
               const std::array<Point, 2>& other, const Rgb8& color);

/// As fill_half_sweep(), and then the rows from the middle corner's to the bottom corner's, between
/// the two sides that meet in the bottom corner. Flat sides must not divide by zero.
///
/// Known faults: sides are drawn by both triangles that share them; corners on whole pixels move
/// the triangle by up to a pixel; cutting towards 0 makes it lean to the left. Corners to ±2^30;
/// throws CheckError beyond.
///
/// Source: B.sweep, second step.
void fill_sweep(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab

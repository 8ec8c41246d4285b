// Exercise 03.3: a segment through the depth buffer.
#pragma once

#include "common/zbuffer/draw_point.h"

namespace rasterlab {

/// An end of a segment.
struct LineEnd {
  Point pixel;
  float z = 0;  ///< NDC depth
  Color color;
};

/// Draws the pixels of the segment from a to b (line_all_octants.h), each by draw_point() with
/// depth (1 − α) z_a + α z_b and colour (1 − α) c_a + α c_b, α being its weight in
/// LineInterpolation. What is outside the image, hidden, or outside [−1, 1] in depth is left out,
/// pixel by pixel; the others do not move because of it.
///
/// A right answer's depth is within 1e-6 and its colour within 1 of 255. a = b is one pixel with
/// a's depth and colour. Coordinates to ±2^30; throws CheckError beyond. Cost: one step per pixel
/// inside the image.
///
/// Source: A.Q28.
void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b);

}  // namespace rasterlab

// Exercise 03.4: a filled triangle through the depth buffer.
#pragma once

#include "common/zbuffer/draw_point.h"

#include <array>

namespace rasterlab {

/// A corner of a triangle.
struct DepthCorner {
  Eigen::Vector2d position;  ///< window coordinates: pixels, y down, may be fractional
  float z = 0;               ///< NDC depth
  Color color;
};

/// Draws the pixels whose centres the triangle covers (rasterize.h), each by draw_point() with
/// depth and colour the corners' values weighted by the pixel's barycentric weights. What is
/// hidden, or outside [−1, 1] in depth, is left out pixel by pixel: two triangles that pass through
/// each other are seen to meet in a line.
///
/// A right answer's depth is within 1e-6 and its colour within 1 of 255. A triangle of no area
/// draws nothing; either winding draws the same. Corners to ±2^30 pixels; throws CheckError beyond,
/// or for a coordinate that is not a number. Cost: one step per pixel covered inside the image.
///
/// Source: A.Q29.
void draw_depth_triangle(Image<Rgb8>& image, DepthBuffer& depth,
                         const std::array<DepthCorner, 3>& corners);

}  // namespace rasterlab

// The examples stage 03 draws: the courses' own, and what the ladder needs to fail on.
#pragma once

#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/visibility.h"

#include <array>
#include <string>
#include <vector>

namespace rasterlab {

/// Exercise 03.4: three triangles of which each passes through the two others, 200 × 200.
const std::vector<std::array<DepthCorner, 3>>& interpenetrating_triangles();

/// Exercise 03.5: a shape seen from above. x is the column it is seen in, y is how far away: 0
/// near, 200 far.
struct FlatShape {
  std::string name;
  Color color;
  std::vector<Point> corners;
};

/// A white square, a green, a blue and a red triangle, in the order they are drawn, in 200 × 200.
const std::vector<FlatShape>& scene_from_above();

/// The triangles of exercise 03.4 as a perspective camera sees them.
VisibilityScene interpenetrating_scene();

/// Pairs of tilted triangles, one row for each decade of distance from 1 (top) to 10⁴ (bottom), one
/// column for each gap 10⁻², 10⁻³ … 10⁻⁷ (right): the second triangle of a pair is nearer by that
/// part of its distance.
VisibilityScene nearly_coplanar_pairs();

}  // namespace rasterlab

// Exercise 02.4, what the box rung asks at every pixel: how a point lies between three corners.
#pragma once

#include "common/triangles/fixed_point.h"

#include <Eigen/Dense>

namespace rasterlab {

/// The barycentric weights of a point, in the order of the corners: point = Σ wᵢ cornerᵢ and Σ wᵢ =
/// 1, all at least 0 exactly where the point is in the triangle or on its border. From two cross
/// products' quotients, in double precision; a right answer is within 1e-9 for corners within
/// ±32768 and a triangle that is no sliver. A triangle without area, in doubles, has no weights:
/// then the result is (−1, −1, −1), which is outside.
///
/// Source: B.box.
Eigen::Vector3d barycentric(const Corners& corners, const Eigen::Vector2d& point);

}  // namespace rasterlab

// Exercise 04.4: perspective as every graphics interface has it.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// From camera space (right-handed, looking along −z, y up) to clip space (visible means −w ≤ x, y,
/// z ≤ w): w is the distance along the view axis, and after the division the plane at distance
/// `near` is at NDC z = −1, the one at `far` at +1.
///
/// `fovy` is the angle between the top and the bottom of the picture, in degrees, `aspect` its
/// width divided by its height. `far` may be infinite, which is the limit of the same formula.
/// Throws CheckError unless 0 < fovy < 180, 0 < aspect, 0 < near < far. Cost: one tangent, once a
/// picture.
///
/// Source: A.Q30, with 60°, 1, 0.1, 20; OpenGL 1.0's gluPerspective.
Eigen::Matrix4f perspective(float fovy, float aspect, float near, float far);

}  // namespace rasterlab

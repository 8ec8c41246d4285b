// Exercise 04.5: the camera as one thinks of it: where it stands, what it looks at, what is up.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// From world to camera space: the matrix [R | −R·eye; 0 0 0 1], R's rows being the camera's axes
/// in the world: right, up, and backward, from `center` to `eye`. So the eye lands on the origin,
/// `center` on the negative z axis, and `up` is seen pointing upward. All finite; `up` need neither
/// be of unit length nor at a right angle to the view. R is orthonormal to 1e-6 and no mirror (det
/// R = +1) whatever is given:
/// - an `up` that is (0, 0, 0), or closer than 1e-7 rad to the line of sight, says nothing about
///   which way is up: instead it is the coordinate axis that the line of sight leans to least (x
///   before y before z where equal);
/// - when `center` is `eye` the camera looks along −z.
///
/// Cost: two cross products, once a picture.
///
/// Source: A.Q30, B.view, C.1 with eye (1, 1, 2), centre 0, up y. The slide's version puts −center
/// where −R·eye belongs, which is right only for a camera whose distance the projection puts back
/// and which looks at the origin.
Eigen::Matrix4f look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& center,
                        const Eigen::Vector3f& up);

}  // namespace rasterlab

// The projection without perspective: given.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// From camera space (right-handed, looking along −z, y up) to clip space, with w = 1 throughout:
/// the picture is `height` high and height · aspect wide, around the view axis; distance `near`
/// lands on NDC z = −1, `far` on +1. Throws CheckError unless height and aspect are above 0 and
/// near < far are finite.
Eigen::Matrix4f orthographic(float height, float aspect, float near, float far);

}  // namespace rasterlab

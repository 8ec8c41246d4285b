// Where a picture is seen from.
#pragma once

#include "common/projection/draw_mesh.h"

#include <Eigen/Dense>

namespace rasterlab {

/// The place of the eye in the world, as (x, y, z, 1); for a projection without perspective, whose
/// eye is infinitely far away, the unit direction toward it, as (x, y, z, 0). It is the point that
/// projection · view takes to x = y = w = 0: the one all lines of sight go through.
Eigen::Vector4f eye_of(const Transforms& transforms);

}  // namespace rasterlab

// Exercise 05.6: the light goes round.
#pragma once

#include "common/projection/scene.h"

#include <Eigen/Dense>

namespace rasterlab {

/// The light carried round an axis through `center`, counter-clockwise seen with the axis pointing
/// at one, by an angle in degrees. A light at infinity (w = 0) only turns: where the axis stands is
/// nothing to it. Everything else about the light stays as it is; all of it does where the axis is
/// (0, 0, 0), or goes through the light. Any angle, below 0 and beyond a turn too. Cost: constant.
///
/// Source: B.light, in 100 frames.
Light turned_light(const Light& light, const Eigen::Vector3f& center, const Eigen::Vector3f& axis,
                   float angle);

}  // namespace rasterlab

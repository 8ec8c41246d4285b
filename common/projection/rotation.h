// Turning things in space: given.
#pragma once

#include <numbers>

#include <Eigen/Dense>

namespace rasterlab {

/// Counter-clockwise about an axis through the origin, seen with the axis pointing at one, by an
/// angle in degrees. The axis need not be of unit length; (0, 0, 0) is none, and nothing turns.
inline Eigen::Matrix4f rotation(float degrees, const Eigen::Vector3f& axis) {
  if (axis.isZero(0)) return Eigen::Matrix4f::Identity();
  const float angle = degrees * std::numbers::pi_v<float> / 180;
  return Eigen::Affine3f(Eigen::AngleAxisf(angle, axis.stableNormalized())).matrix();
}

}  // namespace rasterlab

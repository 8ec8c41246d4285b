#include "common/projection/look_at.h"

#include "common/image/check.h"

namespace rasterlab {
// <solution>
namespace {

// Unit length, for vectors of any magnitude but 0.
Eigen::Vector3d direction(const Eigen::Vector3d& vector) {
  return vector.stableNormalized();
}

// The coordinate axis that a direction leans to least.
Eigen::Vector3d least_axis(const Eigen::Vector3d& direction) {
  int axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  return Eigen::Vector3d::Unit(axis);
}

}  // namespace
// </solution>

Eigen::Matrix4f look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& center,
                        const Eigen::Vector3f& up) {
  // <solution>
  constexpr double smallest_angle = 1e-7;  // what a float's direction is certain to
  const Eigen::Vector3d position = eye.cast<double>();
  const Eigen::Vector3d backward =
      eye == center ? Eigen::Vector3d::UnitZ().eval() : direction(position - center.cast<double>());
  Eigen::Vector3d right = direction(up.cast<double>()).cross(backward);
  if (right.norm() < smallest_angle) right = least_axis(backward).cross(backward);
  right = direction(right);

  Eigen::Matrix3d rotation;
  rotation << right.transpose(), backward.cross(right).transpose(), backward.transpose();
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = rotation;
  view.topRightCorner<3, 1>() = -rotation * position;
  return view.cast<float>();
  // <starter> throw NotWritten("04.5", eye, center, up);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: each matrix from its columns: where the axes go, and the
// origin.
#include "common/projection/transforms_2d.h"

#include "common/image/check.h"

#include <cmath>
#include <limits>

namespace rasterlab {

Eigen::Matrix3f scale_2d(float sx, float sy) {
  Eigen::Matrix3f m;
  m << Eigen::Vector3f(sx, 0, 0), Eigen::Vector3f(0, sy, 0), Eigen::Vector3f::UnitZ();
  return m;
}

Eigen::Matrix3f shear_2d(float x_per_y, float y_per_x) {
  Eigen::Matrix3f m;
  m << Eigen::Vector3f(1, y_per_x, 0), Eigen::Vector3f(x_per_y, 1, 0), Eigen::Vector3f::UnitZ();
  return m;
}

Eigen::Matrix3f rotate_2d(float angle) {
  const Eigen::Vector2f x_axis(std::cos(angle), std::sin(angle));
  Eigen::Matrix3f m;
  m << direction_2d(x_axis.x(), x_axis.y()), direction_2d(-x_axis.y(), x_axis.x()), point_2d(0, 0);
  return m;
}

Eigen::Matrix3f translate_2d(float dx, float dy) {
  Eigen::Matrix3f m = Eigen::Matrix3f::Identity();
  m.col(2) = point_2d(dx, dy);
  return m;
}

Eigen::Matrix3f rotate_about_2d(const Eigen::Vector2f& center, float angle) {
  Eigen::Matrix3f m = rotate_2d(angle);
  m.topRightCorner<2, 1>() = center - m.topLeftCorner<2, 2>() * center;
  return m;
}

Eigen::Vector2f to_plane(const Eigen::Vector3f& homogeneous) {
  if (homogeneous[2] != 0) return homogeneous.hnormalized();
  const float huge = std::numeric_limits<float>::infinity();
  Eigen::Vector2f limit = Eigen::Vector2f::Zero();
  for (int i = 0; i < 2; ++i) {
    if (homogeneous[i] > 0) limit[i] = huge;
    if (homogeneous[i] < 0) limit[i] = -huge;
  }
  return limit;
}

}  // namespace rasterlab

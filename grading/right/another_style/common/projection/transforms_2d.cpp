// A right answer written differently: every matrix is written out, the rotation about a point too.
#include "common/projection/transforms_2d.h"

#include <cmath>
#include <limits>

namespace rasterlab {

Eigen::Matrix3f scale_2d(float sx, float sy) {
  Eigen::Matrix3f m;
  m << sx, 0, 0, 0, sy, 0, 0, 0, 1;
  return m;
}

Eigen::Matrix3f shear_2d(float x_per_y, float y_per_x) {
  Eigen::Matrix3f m;
  m << 1, x_per_y, 0, y_per_x, 1, 0, 0, 0, 1;
  return m;
}

Eigen::Matrix3f rotate_2d(float angle) {
  return rotate_about_2d({0, 0}, angle);
}

Eigen::Matrix3f translate_2d(float dx, float dy) {
  Eigen::Matrix3f m;
  m << 1, 0, dx, 0, 1, dy, 0, 0, 1;
  return m;
}

Eigen::Matrix3f rotate_about_2d(const Eigen::Vector2f& center, float angle) {
  const double c = std::cos(static_cast<double>(angle));
  const double s = std::sin(static_cast<double>(angle));
  const double x = center.x();
  const double y = center.y();
  Eigen::Matrix3d m;
  m << c, -s, x - c * x + s * y, s, c, y - s * x - c * y, 0, 0, 1;
  return m.cast<float>();
}

Eigen::Vector2f to_plane(const Eigen::Vector3f& homogeneous) {
  Eigen::Vector2f point;
  for (int i = 0; i < 2; ++i) {
    const float component = homogeneous[i];
    if (homogeneous.z() != 0) {
      point[i] = component / homogeneous.z();
    } else if (component == 0) {
      point[i] = 0;
    } else {
      const float far = std::numeric_limits<float>::infinity();
      point[i] = component < 0 ? -far : far;
    }
  }
  return point;
}

}  // namespace rasterlab

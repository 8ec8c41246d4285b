// A right answer written differently: Eigen's own transforms.
#include "common/projection/transforms_2d.h"

#include "common/image/check.h"

#include <cmath>
#include <limits>

namespace rasterlab {

Eigen::Matrix3f scale_2d(float sx, float sy) {
  return Eigen::Affine2f(Eigen::Scaling(sx, sy)).matrix();
}

Eigen::Matrix3f shear_2d(float x_per_y, float y_per_x) {
  Eigen::Affine2f shear = Eigen::Affine2f::Identity();
  shear.linear() << 1, x_per_y, y_per_x, 1;
  return shear.matrix();
}

Eigen::Matrix3f rotate_2d(float angle) {
  return Eigen::Affine2f(Eigen::Rotation2Df(angle)).matrix();
}

Eigen::Matrix3f translate_2d(float dx, float dy) {
  return Eigen::Affine2f(Eigen::Translation2f(dx, dy)).matrix();
}

Eigen::Matrix3f rotate_about_2d(const Eigen::Vector2f& center, float angle) {
  const Eigen::Translation2f there(center);
  return (there * Eigen::Affine2f(Eigen::Rotation2Df(angle)) * there.inverse()).matrix();
}

Eigen::Vector2f to_plane(const Eigen::Vector3f& homogeneous) {
  const auto divided = [w = homogeneous.z()](float component) {
    if (component == 0) return w == 0 ? 0.0F : component / w;
    return w == 0 ? component * std::numeric_limits<float>::infinity() : component / w;
  };
  return {divided(homogeneous.x()), divided(homogeneous.y())};
}

}  // namespace rasterlab

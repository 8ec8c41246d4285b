#include "common/projection/transforms_2d.h"

#include "common/image/check.h"

#include <cmath>
#include <limits>

namespace rasterlab {

Eigen::Matrix3f scale_2d(float sx, float sy) {
  // <solution>
  return Eigen::Vector3f(sx, sy, 1).asDiagonal();
  // <starter> throw NotWritten("04.1", sx, sy);
  // </solution>
}

Eigen::Matrix3f shear_2d(float x_per_y, float y_per_x) {
  // <solution>
  Eigen::Matrix3f matrix = Eigen::Matrix3f::Identity();
  matrix(0, 1) = x_per_y;
  matrix(1, 0) = y_per_x;
  return matrix;
  // <starter> throw NotWritten("04.1", x_per_y, y_per_x);
  // </solution>
}

Eigen::Matrix3f rotate_2d(float angle) {
  // <solution>
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  Eigen::Matrix3f matrix;
  matrix << c, -s, 0,  //
      s, c, 0,         //
      0, 0, 1;
  return matrix;
  // <starter> throw NotWritten("04.1", angle);
  // </solution>
}

Eigen::Matrix3f translate_2d(float dx, float dy) {
  // <solution>
  Eigen::Matrix3f matrix = Eigen::Matrix3f::Identity();
  matrix(0, 2) = dx;
  matrix(1, 2) = dy;
  return matrix;
  // <starter> throw NotWritten("04.1", dx, dy);
  // </solution>
}

Eigen::Matrix3f rotate_about_2d(const Eigen::Vector2f& center, float angle) {
  // <solution>
  return translate_2d(center.x(), center.y()) * rotate_2d(angle) *
         translate_2d(-center.x(), -center.y());
  // <starter> throw NotWritten("04.1", center, angle);
  // </solution>
}

Eigen::Vector2f to_plane(const Eigen::Vector3f& homogeneous) {
  // <solution>
  const float w = homogeneous.z();
  if (w != 0) return homogeneous.head<2>() / w;
  const auto far_away = [](float component) {
    return component == 0 ? 0.0F : std::copysign(std::numeric_limits<float>::infinity(), component);
  };
  return {far_away(homogeneous.x()), far_away(homogeneous.y())};
  // <starter> throw NotWritten("04.1", homogeneous);
  // </solution>
}

}  // namespace rasterlab

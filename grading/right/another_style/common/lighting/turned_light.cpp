// A right answer written differently: Rodrigues' formula, without a matrix.
#include "common/lighting/turned_light.h"

#include <cmath>
#include <numbers>

namespace rasterlab {

Light turned_light(const Light& light, const Eigen::Vector3f& center, const Eigen::Vector3f& axis,
                   float angle) {
  if (axis.isZero(0)) return light;
  const double radians = static_cast<double>(angle) * std::numbers::pi / 180;
  const double w = light.position.w();
  const Eigen::Vector3d middle = w * center.cast<double>();
  const Eigen::Vector3d arm = light.position.head<3>().cast<double>() - middle;
  const Eigen::Vector3d a = axis.cast<double>().normalized();
  const Eigen::Vector3d turned = std::cos(radians) * arm + std::sin(radians) * a.cross(arm) +
                                 (1 - std::cos(radians)) * a.dot(arm) * a;
  Light result = light;
  result.position.head<3>() = (middle + turned).cast<float>();
  return result;
}

}  // namespace rasterlab

// A right answer written differently: Rodrigues' formula, in doubles.
#include "common/lighting/turned_light.h"

#include "common/image/check.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

#include <cmath>
#include <numbers>

namespace rasterlab {

Light turned_light(const Light& light, const Eigen::Vector3f& center, const Eigen::Vector3f& axis,
                   float angle) {
  if (axis.isZero(0)) return light;
  const Eigen::Vector3d k = axis.cast<double>().stableNormalized();
  const double radians = static_cast<double>(angle) * std::numbers::pi / 180;
  const double w = light.position.w();
  const Eigen::Vector3d arm = light.position.head<3>().cast<double>() - w * center.cast<double>();
  const Eigen::Vector3d turned_arm = arm * std::cos(radians) + k.cross(arm) * std::sin(radians) +
                                     k * k.dot(arm) * (1 - std::cos(radians));
  Light turned = light;
  turned.position.head<3>() = (turned_arm + w * center.cast<double>()).cast<float>();
  return turned;
}

}  // namespace rasterlab

// A right answer written differently: a quaternion, and the centre taken away and put back by hand.
#include "common/lighting/turned_light.h"

#include "common/image/check.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

#include <cmath>
#include <numbers>

namespace rasterlab {

Light turned_light(const Light& light, const Eigen::Vector3f& center, const Eigen::Vector3f& axis,
                   float angle) {
  Light turned = light;
  if (axis.norm() > 0) {
    const double half = static_cast<double>(angle) * std::numbers::pi / 360;
    const Eigen::Vector3d unit = axis.cast<double>().stableNormalized();
    const Eigen::Quaterniond turn(std::cos(half), std::sin(half) * unit.x(),
                                  std::sin(half) * unit.y(), std::sin(half) * unit.z());
    const Eigen::Vector4d p = light.position.cast<double>();
    const Eigen::Vector3d pivot = p.w() * center.cast<double>();
    const Eigen::Vector3d moved = turn * (p.head<3>() - pivot) + pivot;
    for (int i = 0; i < 3; ++i) turned.position[i] = static_cast<float>(moved[i]);
  }
  return turned;
}

}  // namespace rasterlab

// A right answer written differently: the camera placed in the world first, and that turned back.
#include "common/projection/look_at.h"

#include "common/image/check.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

Eigen::Matrix4f look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& center,
                        const Eigen::Vector3f& up) {
  Eigen::Vector3d z = (eye.cast<double>() - center.cast<double>()).stableNormalized();
  if (z.isZero(0)) z = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d x = up.cast<double>().stableNormalized().cross(z);
  if (!(x.norm() >= 1e-7)) {
    Eigen::Vector3d instead = Eigen::Vector3d::UnitX();
    if (std::abs(z.y()) < std::abs(z.x())) instead = Eigen::Vector3d::UnitY();
    if (std::abs(z.z()) < std::min(std::abs(z.x()), std::abs(z.y())))
      instead = Eigen::Vector3d::UnitZ();
    x = instead.cross(z);
  }
  x.normalize();
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.linear() << x, z.cross(x), z;
  camera.translation() = eye.cast<double>();
  return camera.inverse().matrix().cast<float>();
}

}  // namespace rasterlab

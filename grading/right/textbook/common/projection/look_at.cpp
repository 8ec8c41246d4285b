// A right answer written differently: the camera is put into the world by its axes and its place,
// and that is undone.
#include "common/projection/look_at.h"

#include <cmath>

namespace rasterlab {

Eigen::Matrix4f look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& center,
                        const Eigen::Vector3f& up) {
  Eigen::Vector3d z = (eye - center).cast<double>();
  if (z.isZero(0)) z = {0, 0, 1};
  z.normalize();
  Eigen::Vector3d x = up.cast<double>().stableNormalized().cross(z);
  if (x.norm() < 1e-7) {
    Eigen::Vector3d axis(0, 0, 0);
    const Eigen::Array3d lean = z.array().abs();
    axis[lean[0] <= lean[1] && lean[0] <= lean[2] ? 0 : lean[1] <= lean[2] ? 1 : 2] = 1;
    x = axis.cross(z);
  }
  x.normalize();
  Eigen::Matrix4d to_world = Eigen::Matrix4d::Identity();
  to_world.col(0).head<3>() = x;
  to_world.col(1).head<3>() = z.cross(x);
  to_world.col(2).head<3>() = z;
  to_world.col(3).head<3>() = eye.cast<double>();
  return to_world.inverse().cast<float>();
}

}  // namespace rasterlab

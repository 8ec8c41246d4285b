#include "common/projection/eye.h"

#include <cmath>

namespace rasterlab {

Eigen::Vector4f eye_of(const Transforms& transforms) {
  const Eigen::Matrix4d to_clip =
      transforms.projection.cast<double>() * transforms.view.cast<double>();
  // z in clip space grows away from the eye: so −z is toward it.
  const Eigen::Vector4d eye = to_clip.fullPivLu().solve(Eigen::Vector4d(0, 0, -1, 0));
  const double size = eye.head<3>().norm();
  const bool is_far = std::abs(eye.w()) <= 1e-9 * size;  // w is 0 but for rounding
  const Eigen::Vector4d direction = (Eigen::Vector4d() << eye.head<3>() / size, 0).finished();
  return (is_far ? direction : Eigen::Vector4d(eye / eye.w())).cast<float>();
}

}  // namespace rasterlab

#include "common/projection/orthographic.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {

Eigen::Matrix4f orthographic(float height, float aspect, float near, float far) {
  if (!(height > 0 && aspect > 0)) throw CheckError("height and aspect must be above 0");
  if (!(near < far && std::isfinite(near) && std::isfinite(far))) {
    throw CheckError("an orthographic projection needs near < far, both finite");
  }
  const double depth = static_cast<double>(far) - near;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(0, 0) = 2 / (static_cast<double>(height) * aspect);
  matrix(1, 1) = 2 / static_cast<double>(height);
  matrix(2, 2) = -2 / depth;
  matrix(2, 3) = -(static_cast<double>(far) + near) / depth;
  return matrix.cast<float>();
}

}  // namespace rasterlab

#include "common/projection/perspective.h"

#include "common/image/check.h"

#include <cmath>
#include <numbers>

namespace rasterlab {

Eigen::Matrix4f perspective(float fovy, float aspect, float near, float far) {
  // <solution>
  if (!(fovy > 0 && fovy < 180)) throw CheckError("a field of view is between 0 and 180 degrees");
  if (!(aspect > 0)) throw CheckError("the aspect, width / height, must be above 0");
  if (!(near > 0 && near < far)) throw CheckError("a perspective needs 0 < near < far");
  const double focal = 1 / std::tan(fovy * std::numbers::pi / 360);
  const double near_over_far = static_cast<double>(near) / far;  // 0 when far is infinite
  const double shrink = 1 / (near_over_far - 1);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = focal / aspect;
  matrix(1, 1) = focal;
  matrix(2, 2) = (1 + near_over_far) * shrink;
  matrix(2, 3) = 2 * near * shrink;
  matrix(3, 2) = -1;
  return matrix.cast<float>();
  // <starter> throw NotWritten("04.4", fovy, aspect, near, far);
  // </solution>
}

}  // namespace rasterlab

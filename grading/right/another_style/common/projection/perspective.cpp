// A right answer written differently: the planes of glFrustum, at the near plane's own size.
#include "common/projection/perspective.h"

#include "common/image/check.h"

#include <cmath>
#include <numbers>

namespace rasterlab {

Eigen::Matrix4f perspective(float fovy, float aspect, float near, float far) {
  const bool good = fovy > 0 && fovy < 180 && aspect > 0 && near > 0 && near < far;
  if (!good) throw CheckError("expected 0 < fovy < 180, 0 < aspect, 0 < near < far");
  const double top = near * std::tan(fovy / 2.0 * std::numbers::pi / 180.0);
  const double right = top * aspect;
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = near / right;
  m(1, 1) = near / top;
  if (std::isinf(far)) {
    m(2, 2) = -1;
    m(2, 3) = -2.0 * near;
  } else {
    m(2, 2) = -(double(far) + near) / (double(far) - near);
    m(2, 3) = -2.0 * far * near / (double(far) - near);
  }
  m.row(3) = Eigen::RowVector4d(0, 0, -1, 0);
  return m.cast<float>();
}

}  // namespace rasterlab

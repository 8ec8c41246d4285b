// A right answer written differently: gluPerspective's own formula, and its limit where far is
// infinite.
#include "common/projection/perspective.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {

Eigen::Matrix4f perspective(float fovy, float aspect, float near, float far) {
  if (!(fovy > 0 && fovy < 180) || !(aspect > 0) || !(near > 0) || !(far > near))
    throw CheckError("no such perspective");
  const float half_angle = fovy / 2 * 3.14159265F / 180;
  const float cotangent = 1 / std::tan(half_angle);
  const bool endless = std::isinf(far);
  const float a = endless ? -1 : (far + near) / (near - far);
  const float b = endless ? -2 * near : 2 * far * near / (near - far);
  Eigen::Matrix4f matrix;
  matrix << cotangent / aspect, 0, 0, 0, 0, cotangent, 0, 0, 0, 0, a, b, 0, 0, -1, 0;
  return matrix;
}

}  // namespace rasterlab

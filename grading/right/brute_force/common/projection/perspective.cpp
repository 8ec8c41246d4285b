// A right answer written differently: depth by two equations: near goes to -1, far to +1.
#include "common/projection/perspective.h"

#include "common/image/check.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace rasterlab {

Eigen::Matrix4f perspective(float fovy, float aspect, float near, float far) {
  if (!(fovy > 0) || !(fovy < 180)) throw CheckError("expected an angle between 0 and 180 degrees");
  if (!(aspect > 0)) throw CheckError("expected an aspect above 0");
  if (!(0 < near) || !(near < far)) throw CheckError("expected 0 < near < far");
  const double half = fovy * std::numbers::pi / 180 / 2;
  const double scale = std::cos(half) / std::sin(half);
  // At the distance d along the axis z = b - a d and w = d: b/near - a = -1, b/far - a = 1.
  double a = -1;
  double b = -2.0 * near;
  if (far != std::numeric_limits<float>::infinity()) {
    const double one_over_near = 1.0 / near, one_over_far = 1.0 / far;
    b = 2 / (one_over_far - one_over_near);
    a = b * one_over_far - 1;
  }
  Eigen::Matrix4d m;
  m << scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, a, b, 0, 0, -1, 0;
  return m.cast<float>();
}

}  // namespace rasterlab

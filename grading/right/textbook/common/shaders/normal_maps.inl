// A right answer written differently: the three axes by Gram and Schmidt, the sum component by
// component.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> normal_from_tangent_space(const Vector3<Number>& local,
                                          const Vector3<Number>& normal,
                                          const Vector3<Number>& tangent,
                                          const Number& handedness) {
  const Vector3<Number> up = normalized(normal);
  const Number along = dot(up, tangent);
  const Vector3<Number> right = normalized(Vector3<Number>(
      tangent.x() - along * up.x(), tangent.y() - along * up.y(), tangent.z() - along * up.z()));
  const Vector3<Number> ahead = cross(up, right);
  const Number y = handedness * local.y();
  Vector3<Number> sum;
  for (int i = 0; i < 3; ++i) sum[i] = local.x() * right[i] + y * ahead[i] + local.z() * up[i];
  return normalized(sum);
}

}  // namespace rasterlab

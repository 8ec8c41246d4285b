// Exercise 07.4; the contract is in normal_maps.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> normal_from_tangent_space(const Vector3<Number>& local,
                                          const Vector3<Number>& normal,
                                          const Vector3<Number>& tangent,
                                          const Number& handedness) {
  // <solution>
  const Vector3<Number> n = normalized(normal);
  const Vector3<Number> t = normalized(Vector3<Number>(tangent - n * dot(n, tangent)));
  const Vector3<Number> b = cross(n, t) * handedness;
  return normalized(Vector3<Number>(t * local.x() + b * local.y() + n * local.z()));
  // <starter> throw NotWritten("07.4", local, normal, tangent, handedness);
  // </solution>
}

}  // namespace rasterlab

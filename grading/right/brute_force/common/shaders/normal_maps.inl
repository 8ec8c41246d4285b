// A right answer written differently: the binormal before the tangent, and the tangent from that.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> normal_from_tangent_space(const Vector3<Number>& local,
                                          const Vector3<Number>& normal,
                                          const Vector3<Number>& tangent,
                                          const Number& handedness) {
  const Vector3<Number> n = normalized(normal);
  const Vector3<Number> across = normalized(cross(n, tangent));
  // A surface without a normal still has its tangent.
  const Vector3<Number> t =
      select(dot(n, n) > Number(0), Vector3<Number>(cross(across, n)), normalized(tangent));
  Vector3<Number> bent(n * local.z());
  bent += t * local.x();
  bent += across * Number(local.y() * handedness);
  return normalized(bent);
}

}  // namespace rasterlab

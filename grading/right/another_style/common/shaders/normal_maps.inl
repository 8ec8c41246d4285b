// A right answer written differently: the axes as columns of a matrix, the tangent found through
// the third axis.
#pragma once

namespace rasterlab {

template <class Number>
Vector3<Number> normal_from_tangent_space(const Vector3<Number>& local,
                                          const Vector3<Number>& normal,
                                          const Vector3<Number>& tangent,
                                          const Number& handedness) {
  const Vector3<Number> n = normalized(normal);
  const Vector3<Number> across = normalized(cross(n, tangent));
  const Vector3<Number> along =
      select(dot(n, n) > Number(0), Vector3<Number>(cross(across, n)), normalized(tangent));
  Vector3<Number> turned;
  for (int i = 0; i < 3; ++i)
    turned[i] = along[i] * local.x() + handedness * across[i] * local.y() + n[i] * local.z();
  return normalized(turned);
}

}  // namespace rasterlab

// A right answer written differently: directions by differences of its own, light at infinity or
// not.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class NormalSource>
Reflection<typename Point::Number> Phong::light_at(const Point& point,
                                                   const NormalSource& normals) const {
  using Number = typename Point::Number;
  const Vector3<Number> position = point.value.position;
  const auto toward = [&position](const Eigen::Vector4f& goal) {
    Vector3<Number> way;
    for (int i = 0; i < 3; ++i) way[i] = Number(goal[i]) - Number(goal[3]) * position[i];
    return normalized(way);
  };
  return phong(Vector3<Number>(normals.normal_at(point)), toward(light.position), toward(eye),
               light, material);
}

template <class Point, class NormalSource>
Reflection<typename Point::Number> BlinnPhong::light_at(const Point& point,
                                                        const NormalSource& normals) const {
  using Number = typename Point::Number;
  const Vector3<Number> position = point.value.position;
  const auto toward = [&position](const Eigen::Vector4f& goal) {
    Vector3<Number> way;
    for (int i = 0; i < 3; ++i) way[i] = Number(goal[i]) - Number(goal[3]) * position[i];
    return normalized(way);
  };
  return blinn_phong(Vector3<Number>(normals.normal_at(point)), toward(light.position), toward(eye),
                     light, material);
}

}  // namespace rasterlab

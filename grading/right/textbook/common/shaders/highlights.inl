// A right answer written differently: each direction named.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class NormalSource>
Reflection<typename Point::Number> Phong::light_at(const Point& point,
                                                   const NormalSource& normals) const {
  const auto normal = normals.normal_at(point);
  const auto to_light = direction_to(light.position, point.value.position);
  const auto to_eye = direction_to(eye, point.value.position);
  return phong(normal, to_light, to_eye, light, material);
}

template <class Point, class NormalSource>
Reflection<typename Point::Number> BlinnPhong::light_at(const Point& point,
                                                        const NormalSource& normals) const {
  const auto normal = normals.normal_at(point);
  const auto to_light = direction_to(light.position, point.value.position);
  const auto to_eye = direction_to(eye, point.value.position);
  return blinn_phong(normal, to_light, to_eye, light, material);
}

}  // namespace rasterlab

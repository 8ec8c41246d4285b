// Exercise 07.6; the contract is in highlights.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class NormalSource>
Reflection<typename Point::Number> Phong::light_at(const Point& point,
                                                   const NormalSource& normals) const {
  // <solution>
  const auto& position = point.value.position;
  return phong(normals.normal_at(point), direction_to(light.position, position),
               direction_to(eye, position), light, material);
  // <starter> throw NotWritten("07.6", point, normals);
  // </solution>
}

template <class Point, class NormalSource>
Reflection<typename Point::Number> BlinnPhong::light_at(const Point& point,
                                                        const NormalSource& normals) const {
  // <solution>
  const auto& position = point.value.position;
  return blinn_phong(normals.normal_at(point), direction_to(light.position, position),
                     direction_to(eye, position), light, material);
  // <starter> throw NotWritten("07.6", point, normals);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: Phong and Blinn side by side, each with the normal asked
// last.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class NormalSource>
Reflection<typename Point::Number> Phong::light_at(const Point& point,
                                                   const NormalSource& normals) const {
  const auto& here = point.value.position;
  const auto l = direction_to(this->light.position, here);
  const auto e = direction_to(this->eye, here);
  return phong(normals.normal_at(point), l, e, this->light, this->material);
}

template <class Point, class NormalSource>
Reflection<typename Point::Number> BlinnPhong::light_at(const Point& point,
                                                        const NormalSource& normals) const {
  const auto& here = point.value.position;
  const auto l = direction_to(this->light.position, here);
  const auto e = direction_to(this->eye, here);
  return blinn_phong(normals.normal_at(point), l, e, this->light, this->material);
}

}  // namespace rasterlab

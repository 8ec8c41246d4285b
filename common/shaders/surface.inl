// Exercise 07.2; the contract is in surface.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class ColorSource, class NormalSource, class LightModel>
Vector3<typename Point::Number> surface_color(const Point& point, const ColorSource& color,
                                              const NormalSource& normals,
                                              const LightModel& light) {
  // <solution>
  return lit(color.color_at(point), light.light_at(point, normals));
  // <starter> throw NotWritten("07.2", point, &color, &normals, &light);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: the light asked first.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class ColorSource, class NormalSource, class LightModel>
Vector3<typename Point::Number> surface_color(const Point& point, const ColorSource& color,
                                              const NormalSource& normals,
                                              const LightModel& light) {
  auto in_light = light.light_at(point, normals);
  auto of_surface = color.color_at(point);
  return Vector3<typename Point::Number>(lit(of_surface, in_light));
}

}  // namespace rasterlab

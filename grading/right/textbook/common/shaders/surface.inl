// A right answer written differently: colour and light named before they are put together.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class ColorSource, class NormalSource, class LightModel>
Vector3<typename Point::Number> surface_color(const Point& point, const ColorSource& color,
                                              const NormalSource& normals,
                                              const LightModel& light) {
  const Vector3<typename Point::Number> own = color.color_at(point);
  const auto shade = light.light_at(point, normals);
  return lit(own, shade);
}

}  // namespace rasterlab

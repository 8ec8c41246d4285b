// A right answer written differently: straight through, by names that say what they are.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point, class ColorSource, class NormalSource, class LightModel>
Vector3<typename Point::Number> surface_color(const Point& point, const ColorSource& color,
                                              const NormalSource& normals,
                                              const LightModel& light) {
  using Result = Vector3<typename Point::Number>;
  const auto put_together = [](const auto& own, const auto& seen_light) -> Result {
    return lit(own, seen_light);
  };
  return put_together(color.color_at(point), light.light_at(point, normals));
}

}  // namespace rasterlab

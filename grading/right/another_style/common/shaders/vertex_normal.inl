// A right answer written differently: through a name of its own.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point>
Vector3<typename Point::Number> VertexNormal::normal_at(const Point& point) const {
  Vector3<typename Point::Number> unit = point.value.normal;
  unit = normalized(unit);
  return unit;
}

}  // namespace rasterlab

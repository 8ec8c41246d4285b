// A right answer written differently: divided by its length where it has one.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Point>
Vector3<typename Point::Number> VertexNormal::normal_at(const Point& point) const {
  using Number = typename Point::Number;
  const Vector3<Number> mixed = point.value.normal;
  const Number length = square_root(dot(mixed, mixed));
  const Number divisor = select(length > Number(0), length, Number(1));
  return {mixed.x() / divisor, mixed.y() / divisor, mixed.z() / divisor};
}

}  // namespace rasterlab

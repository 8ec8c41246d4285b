// Exercise 07.8; the contract is in vertex_normal.h.
#pragma once

namespace rasterlab {

template <class Point>
Vector3<typename Point::Number> VertexNormal::normal_at(const Point& point) const {
  return normalized(point.value.normal);
}

}  // namespace rasterlab

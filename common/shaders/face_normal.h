// Where a surface's normal comes from: the second of Surface's three parts.
//
// A normal source is made from a shader's inputs, says which attributes it reads, and gives the
// normal of a point: of unit length, in the world.
#pragma once

#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"

namespace rasterlab {

/// The face's: every pixel of a face has the same. Zero, which no light but the ambient reaches,
/// where the face has no area. Source: B.flat.
struct FaceNormal {
  using Reads = Attributes<FaceNormals>;
  static constexpr bool reads_derivatives = false;

  explicit FaceNormal(const ShaderInputs& /*inputs*/) {}

  template <class Point>
  auto normal_at(const Point& point) const {
    return point.value.face_normal;
  }
};

}  // namespace rasterlab

// Exercise 07.8: the normal of a pixel, so that each is lit by itself.
#pragma once

#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"

namespace rasterlab {

/// The normal source (face_normal.h) of smooth surfaces: the normals of the vertices, mixed.
///
/// A mixture of unit vectors is shorter than a unit, the more so the more they differ, which would
/// darken the middle of a face and drown its highlight: so it is renormalised. Opposite normals may
/// mix to the zero vector, which stays zero: such a pixel gets ambient light alone. In the world;
/// needs a mesh with normals. Cost: one square root.
///
/// Source: A.Q34; Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975.
struct VertexNormal {
  using Reads = Attributes<VertexNormals>;
  static constexpr bool reads_derivatives = false;

  explicit VertexNormal(const ShaderInputs& /*inputs*/) {}

  template <class Point>
  Vector3<typename Point::Number> normal_at(const Point& point) const;
};

}  // namespace rasterlab

#include "common/shaders/vertex_normal.inl"

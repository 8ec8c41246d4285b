// Colours that were computed before, as shaders (common/mesh/shader_types.h): how stages 04 and 05
// draw with the engine.
#pragma once

#include "common/image/pixel.h"
#include "common/mesh/shader_types.h"

#include <cstdint>
#include <vector>

namespace rasterlab {

/// A colour for each vertex of the mesh, mixed between them.
struct VertexColorShader {
  static constexpr bool reads_derivatives = false;

  template <class Number>
  struct Varyings {
    Vector3<Number> color;
  };

  const std::vector<Color>& colors;

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {colors[mesh.triangles[triangle][static_cast<std::size_t>(corner)]]};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return point.value.color;
  }
};

/// A colour for each triangle.
struct FaceColorShader : VertexColorShader {
  Varyings<float> vertex(const Mesh& /*mesh*/, std::uint32_t triangle, int /*corner*/) const {
    return {colors[triangle]};
  }
};

}  // namespace rasterlab

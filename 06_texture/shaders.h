// Light at every pixel, with and without a texture, as shaders (common/mesh/shader_types.h): how
// this stage draws with the engine what shade_phong() and draw_textured_mesh() draw by hand.
#pragma once

#include "common/lighting/surface_lighting.h"
#include "common/mesh/shader_types.h"
#include "common/texture/sample.h"

#include <cstdint>

namespace rasterlab {

/// The colours of the vertices in the light of stage 05.
struct LitColors {
  static constexpr bool reads_derivatives = false;

  template <class Number>
  struct Varyings {
    Vector3<Number> position;  ///< in the world, as is the normal
    Vector3<Number> normal;
    Vector3<Number> color;
  };

  const SurfaceLighting& lighting;

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    const auto [position, normal, color] = lighting.vertex(index);
    return {position, normal, color};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return lighting.light<Number>(
        {point.value.position, normalized(point.value.normal), point.value.color});
  }
};

/// A texture in the same light.
struct LitTexture {
  template <class Number>
  struct Varyings {
    Vector3<Number> position;
    Vector3<Number> normal;
    Vector2<Number> uv;
  };

  const SurfaceLighting& lighting;
  Sampler texture;

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    const auto [position, normal, color] = lighting.vertex(index);
    return {position, normal, mesh.texture_coordinates[index]};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Footprint<Number> footprint = {point.value.uv, point.dx.uv, point.dy.uv};
    return lighting.light<Number>(
        {point.value.position, normalized(point.value.normal), sample(texture, footprint)});
  }
};

}  // namespace rasterlab

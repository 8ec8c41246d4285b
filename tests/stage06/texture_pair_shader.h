// A shader that reads two textures, for tests.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/texture/texture_pair.h"

namespace rasterlab {

/// Red is one's, green the other's, blue half of both. Positions are texture coordinates.
struct TexturePairShader {
  TexturePair textures;
  bool at_once;  ///< else one after the other

  template <class Number>
  struct Varyings {
    Vector2<Number> uv;
  };

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    return {mesh.positions[index].head<2>()};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Footprint<Number> footprint = {point.value.uv, point.dx.uv, point.dy.uv};
    const auto alone = [&](const Texture& texture) {
      return sample_trilinear(texture, Wrap::repeat, footprint);
    };
    const ColorPair<Number> colors =
        at_once ? sample_trilinear(textures, Wrap::repeat, footprint)
                : ColorPair<Number>{alone(textures.one()), alone(textures.other())};
    return {colors.one.x(), colors.other.y(), (colors.one.z() + colors.other.z()) * Number(0.5F)};
  }
};

}  // namespace rasterlab

// A shader that refuses pixels, through which one sees what is behind.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"
#include "common/shaders/light_models.h"
#include "common/shaders/vertex_normal.h"

#include <cstdint>

namespace rasterlab {

/// A surface cut to a lattice along its texture coordinates: of each of 32 × 16 cells the middle is
/// a hole. Both sides are lit, each as if it faced the viewer: fronts in the surface's colour,
/// backs in red. No ambient light. Needs a mesh with normals and texture coordinates. Source:
/// B.shaders, whose fragment() may refuse.
struct Lattice {
  using Reads = Attributes<TextureCoordinates, WorldPosition, VertexNormals>;
  static constexpr bool reads_derivatives = false;
  template <class Number>
  struct Varyings : Reads::Varyings<Number> {};

  Reads attributes;
  VertexNormal normals;
  Light light;
  Color front;
  Color back = Color(0.8F, 0.25F, 0.2F);

  explicit Lattice(const ShaderInputs& inputs)
      : attributes(inputs),
        normals(inputs),
        light(inputs.light),
        front(inputs.color.value_or(default_color())) {}

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {attributes.at(mesh, triangle, corner)};
  }

  template <class Number>
  Fragment<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const auto in_hole = [](const Number& coordinate, float cells) {
      const Number in_cells = coordinate * Number(cells);
      return magnitude(in_cells - round_down(in_cells) - Number(0.5F)) < Number(0.3F);
    };
    const Vector3<Number> color =
        select<Number, 3>(point.front_facing, broadcast<Number>(front), broadcast<Number>(back));
    const Number toward_viewer = select(point.front_facing, Number(1), Number(-1));
    const Number cosine = toward_viewer * dot(normals.normal_at(point),
                                              direction_to(light.position, point.value.position));
    return {lit(color, Shade<Number>{Number(light.intensity) * maximum(cosine, Number(0))}),
            in_hole(point.value.uv.x(), 32) && in_hole(point.value.uv.y(), 16)};
  }
};

}  // namespace rasterlab

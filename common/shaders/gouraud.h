// Light computed at the corners of a triangle, and mixed between them.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"

#include <array>
#include <cstdint>

namespace rasterlab {

/// What a light model gives at a corner, as an attribute.
template <class LightModel, class NormalSource>
struct LightAtCorners {
  using Reads = typename LightModel::template Reads<NormalSource>;
  static constexpr bool reads_vertex_normals = Reads::reads_vertex_normals;
  template <class Number>
  using Point = SurfacePoint<Reads::template Varyings, Number>;

  /// The same members as the light model's own result, Shade or ShadeAndHighlight.
  template <class Number>
  struct Varying : decltype(std::declval<LightModel>().light_at(std::declval<Point<Number>>(),
                                                                std::declval<NormalSource>())) {};

  Reads attributes;
  NormalSource normals;
  LightModel light;

  explicit LightAtCorners(const ShaderInputs& inputs)
      : attributes(inputs), normals(inputs), light(inputs) {}

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    Point<float> point{};
    point.value = attributes.at(mesh, triangle, corner);
    point.front_facing = true;
    return {light.light_at(point, normals)};
  }
};

/// Any light model, evaluated at the corners only: as cheap as there are few vertices, and blind to
/// a highlight that falls between them. What is mixed is what the model gives, light and not
/// colours, perspective-correctly: a texture stays sharp. Corners are lit as fronts.
///
/// Source: Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers
/// C-20(6), 1971; B.gouraud.
template <class LightModel>
struct Gouraud {
  template <class NormalSource>
  using Reads = Attributes<LightAtCorners<LightModel, NormalSource>>;
  static constexpr bool reads_derivatives = false;

  explicit Gouraud(const ShaderInputs& /*inputs*/) {}

  template <class Point, class NormalSource>
  auto light_at(const Point& point, const NormalSource& /*normals*/) const {
    using Mixed =
        typename LightAtCorners<LightModel, NormalSource>::template Varying<typename Point::Number>;
    return static_cast<const Mixed&>(point.value);
  }
};

}  // namespace rasterlab

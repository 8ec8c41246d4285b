// Where a surface's colour comes from: the first of Surface's three parts.
//
// A colour source is made from a shader's inputs, says which attributes it reads, and gives the
// colour of a point: red, green, blue in [0, 1]. Like the other two parts it says so if it reads no
// derivatives (shader_types.h).
#pragma once

#include "common/mesh/shader_types.h"
#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"
#include "common/texture/sample.h"

namespace rasterlab {

/// One colour all over: the inputs', else default_color(), whatever colours the mesh has.
struct ConstantColor {
  using Reads = Attributes<>;
  static constexpr bool reads_derivatives = false;

  Color color;

  explicit ConstantColor(const ShaderInputs& inputs)
      : color(inputs.color.value_or(default_color())) {}

  template <class Point>
  auto color_at(const Point& /*point*/) const {
    return broadcast<typename Point::Number>(color);
  }
};

/// The colours of the mesh's corners, mixed. Needs a mesh with colours.
struct VertexColor {
  using Reads = Attributes<VertexColors>;
  static constexpr bool reads_derivatives = false;

  explicit VertexColor(const ShaderInputs& /*inputs*/) {}

  template <class Point>
  auto color_at(const Point& point) const {
    return point.value.color;
  }
};

/// What of a texture a pixel sees.
template <class Point>
Footprint<typename Point::Number> footprint_of(const Point& point) {
  return {point.value.uv, point.dx.uv, point.dy.uv};
}

/// A texture, by the filter of its sampler. The constructor throws InputError where the inputs have
/// none or the mesh has no texture coordinates.
struct TextureColor {
  using Reads = Attributes<TextureCoordinates>;

  Sampler texture;

  explicit TextureColor(const ShaderInputs& inputs)
      : texture(required(inputs.texture, "--texture")) {}

  template <class Point>
  auto color_at(const Point& point) const {
    return sample(texture, footprint_of(point));
  }
};

}  // namespace rasterlab

// How a surface answers the light: the last of Surface's three parts.
//
// A light model is made from a shader's inputs, says which attributes it reads besides what a
// surface's normals need, and gives what comes back from a point: a Shade, or a Reflection of
// common/lighting. It asks for a normal, a unit vector in the world, only if it needs one.
#pragma once

#include "common/lighting/reflection.h"
#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"

namespace rasterlab {

/// By what a surface's colour is multiplied: all there is to light without a highlight.
template <class Number>
struct Shade {
  Number shade;
};

/// A surface's colour in that light.
template <class Number>
Vector3<Number> lit(const Vector3<Number>& color, const Shade<Number>& light) {
  return {color.x() * light.shade, color.y() * light.shade, color.z() * light.shade};
}

/// No light: the surface's colour as it is.
struct Unlit {
  template <class NormalSource>
  using Reads = Attributes<>;
  static constexpr bool reads_derivatives = false;

  explicit Unlit(const ShaderInputs& /*inputs*/) {}

  template <class Point, class NormalSource>
  Shade<typename Point::Number> light_at(const Point& /*point*/,
                                         const NormalSource& /*normals*/) const {
    return {typename Point::Number(1)};
  }
};

/// What a light model that depends on place and normal reads.
template <class NormalSource>
using ReadsOfPointAndNormal = United<Attributes<WorldPosition>, typename NormalSource::Reads>;

/// The cosine of the angle between normal and light, 0 where the light is behind and where the
/// normal is zero, times the light's intensity: Lambert's law, and no ambient light. May exceed 1
/// with the intensity. Source: B.gouraud.
struct Diffuse {
  template <class NormalSource>
  using Reads = ReadsOfPointAndNormal<NormalSource>;
  static constexpr bool reads_derivatives = false;

  Light light;

  explicit Diffuse(const ShaderInputs& inputs) : light(inputs.light) {}

  template <class Point, class NormalSource>
  Shade<typename Point::Number> light_at(const Point& point, const NormalSource& normals) const {
    using Number = typename Point::Number;
    const Vector3<Number> to_light = direction_to(light.position, point.value.position);
    const Number cosine = dot(normals.normal_at(point), to_light);
    return {Number(light.intensity) * maximum(cosine, Number(0))};
  }
};

}  // namespace rasterlab

// Exercise 07.2: shaders put together from three parts, so that no line is written twice.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/shaders/attributes.h"
#include "common/shaders/inputs.h"
#include "common/shaders/light_models.h"

#include <cstdint>

namespace rasterlab {

/// The colour of a point: what the colour source says, in the light that the light model says, as
/// lit() of the light model's result puts the two together: color · shade for a Shade, not clamped
/// above, or, at most 1, that of common/lighting/reflection.h for a Reflection. The normal source
/// is handed to the light model, which asks it or does not. Cost: what its parts cost.
template <class Point, class ColorSource, class NormalSource, class LightModel>
Vector3<typename Point::Number> surface_color(const Point& point, const ColorSource& color,
                                              const NormalSource& normals, const LightModel& light);

/// The shader of a surface whose colour comes from `ColorSource` (color_sources.h), whose normal
/// from `NormalSource` (face_normal.h, vertex_normal.h, normal_maps.h), and which answers light as
/// `LightModel` says (light_models.h, gouraud.h, quantized.h, highlights.h). Its varyings are the
/// attributes its parts read, each once: what no part reads is not interpolated, and derivatives
/// are there only if one of the parts may read them.
///
/// The parts are template parameters, so their calls are resolved when it is compiled: a pixel
/// costs no virtual call. Source: B.refactor.
template <class ColorSource, class NormalSource, class LightModel>
struct Surface {
  using Reads =
      United<typename ColorSource::Reads, typename LightModel::template Reads<NormalSource>>;
  static constexpr bool reads_vertex_normals = Reads::reads_vertex_normals;
  static constexpr bool reads_derivatives = rasterlab::reads_derivatives<ColorSource>() ||
                                            rasterlab::reads_derivatives<NormalSource>() ||
                                            rasterlab::reads_derivatives<LightModel>();
  template <class Number>
  struct Varyings : Reads::template Varyings<Number> {};

  Reads attributes;
  ColorSource color;
  NormalSource normals;
  LightModel light;

  explicit Surface(const ShaderInputs& inputs)
      : attributes(inputs), color(inputs), normals(inputs), light(inputs) {}

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {attributes.at(mesh, triangle, corner)};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return surface_color(point, color, normals, light);
  }
};

}  // namespace rasterlab

#include "common/shaders/surface.inl"

// Exercise 07.6: light models with a highlight, for each pixel by itself.
#pragma once

#include "common/lighting/blinn_phong.h"
#include "common/lighting/phong.h"
#include "common/projection/eye.h"
#include "common/shaders/color_sources.h"
#include "common/shaders/inputs.h"
#include "common/shaders/light_models.h"

namespace rasterlab {

/// Phong's reflection (common/lighting/phong.h) with the normal, light and eye of this very point,
/// all in the world. That header says what happens on a side turned away from light or eye, and to
/// a normal that is zero. Cost: three square roots and one power. Source: B.phong.
struct Phong {
  template <class NormalSource>
  using Reads = ReadsOfPointAndNormal<NormalSource>;
  static constexpr bool reads_derivatives = false;

  Light light;
  Material material;
  Eigen::Vector4f eye;  ///< in the world, w = 0 for a projection without perspective

  explicit Phong(const ShaderInputs& inputs)
      : light(inputs.light), material(inputs.material), eye(eye_of(inputs.transforms)) {}

  template <class Point, class NormalSource>
  Reflection<typename Point::Number> light_at(const Point& point,
                                              const NormalSource& normals) const;
};

/// Blinn's in its place (common/lighting/blinn_phong.h). Source: C.4.
struct BlinnPhong : Phong {
  using Phong::Phong;

  template <class Point, class NormalSource>
  Reflection<typename Point::Number> light_at(const Point& point,
                                              const NormalSource& normals) const;
};

/// Either of them, its highlight multiplied by what a texture's red, in [0, 1], says: a sea shines
/// and the land does not. The constructor throws InputError where the inputs have no specular map.
template <class LightModel>
struct SpecularMapped {
  template <class NormalSource>
  using Reads =
      United<Attributes<TextureCoordinates>, typename LightModel::template Reads<NormalSource>>;

  Sampler map;
  LightModel light;

  explicit SpecularMapped(const ShaderInputs& inputs)
      : map(required(inputs.specular_map, "--specular-map")), light(inputs) {}

  template <class Point, class NormalSource>
  Reflection<typename Point::Number> light_at(const Point& point,
                                              const NormalSource& normals) const {
    auto reflection = light.light_at(point, normals);
    reflection.specular *= sample(map, footprint_of(point)).x();
    return reflection;
  }
};

}  // namespace rasterlab

#include "common/shaders/highlights.inl"

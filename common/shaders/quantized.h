// Exercise 07.3: as many shades as a comic has.
#pragma once

#include "common/shaders/inputs.h"
#include "common/shaders/light_models.h"

namespace rasterlab {

/// A value of [0, 1] to one of `levels` ≥ 2 evenly spaced ones, 0 and 1 among them: [0, 1] is cut
/// into `levels` bands of equal width, the lowest becomes 0, the highest, with 1, becomes 1. Below
/// 0 and NaN count as 0, above 1 as 1. Cost: one rounding.
template <class Number>
Number quantize(const Number& value, int levels);

/// Any light model that gives a shade (light_models.h), in five levels: 0, ¼, ½, ¾ and 1. What is
/// quantized is the light and not the colour, whose hue stays. Source: B.quantized.
template <class LightModel>
struct Quantized {
  static constexpr int levels = 5;

  template <class NormalSource>
  using Reads = typename LightModel::template Reads<NormalSource>;
  static constexpr bool reads_derivatives = rasterlab::reads_derivatives<LightModel>();

  LightModel light;

  explicit Quantized(const ShaderInputs& inputs) : light(inputs) {}

  template <class Point, class NormalSource>
  Shade<typename Point::Number> light_at(const Point& point, const NormalSource& normals) const {
    return {quantize(light.light_at(point, normals).shade, levels)};
  }
};

}  // namespace rasterlab

#include "common/shaders/quantized.inl"

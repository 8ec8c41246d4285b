// A shader that writes powers into a picture, to 24 bits.
#pragma once

#include "tests/engine/encode_shader.h"

#include <vector>

namespace rasterlab {

/// Two numbers for each triangle, base and exponent; its colour is base^exponent.
struct PowerShader {
  std::vector<float> numbers;

  template <class Number>
  struct Varyings {
    Number base;
    Number exponent;
  };

  Varyings<float> vertex(const Mesh&, std::uint32_t triangle, int) const {
    return {numbers[2 * triangle], numbers[2 * triangle + 1]};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return encode(power(point.value.base, point.value.exponent));
  }
};

}  // namespace rasterlab

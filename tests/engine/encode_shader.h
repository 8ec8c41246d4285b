// A shader that writes an attribute's value into a picture, to 24 bits.
#pragma once

#include "common/mesh/shader_types.h"

#include <array>

namespace rasterlab {

/// A number in [0, 1] as the colour (2^24 − 1) · number in three bytes, the highest first; off by
/// 1.5 at the most.
template <class Number>
Vector3<Number> encode(const Number& number) {
  constexpr float largest = 16777215;
  const Number code =
      minimum(round_down(Number(number * Number(largest) + Number(0.5F))), Number(largest));
  const Number high = round_down(Number(code * Number(1.0F / 65536)));
  const Number rest = code - high * Number(65536);
  const Number middle = round_down(Number(rest * Number(1.0F / 256)));
  const Number low = rest - middle * Number(256);
  return {high / Number(255), middle / Number(255), low / Number(255)};
}

/// The attribute of one triangle's corners, in [0, 1], encoded.
struct EncodeShader {
  std::array<float, 3> at_corner;

  template <class Number>
  struct Varyings {
    Number value;
  };

  Varyings<float> vertex(const Mesh&, std::uint32_t, int corner) const {
    return {at_corner[static_cast<std::size_t>(corner)]};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return encode(point.value.value);
  }
};

/// How fast it grows to the right, or down, of ±1 / scale: −1 / scale is encoded as 0, 1 / scale
/// as 1.
struct EncodeDerivativeShader : EncodeShader {
  bool down;
  float scale;

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Number slope = down ? point.dy.value : point.dx.value;
    return encode(Number((slope * Number(scale) + Number(1)) * Number(0.5F)));
  }
};

/// base^exponent, encoded; the exponent the same everywhere.
struct UniformPowerShader {
  float base;
  float exponent;

  template <class Number>
  struct Varyings {
    Number base;
  };

  Varyings<float> vertex(const Mesh&, std::uint32_t, int) const { return {base}; }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return encode(power(point.value.base, exponent));
  }
};

inline double decode(int red, int green, int blue) {
  return (red * 65536.0 + green * 256.0 + blue) / 16777215.0;
}

}  // namespace rasterlab

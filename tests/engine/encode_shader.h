// A shader that writes an attribute's value into a picture, to 24 bits.
#pragma once

#include "common/mesh/shader_types.h"

#include <array>

namespace rasterlab {

/// The attribute of one triangle's corners, in [0, 1]; its colour is the number 2^24 · value in
/// three bytes, the highest first.
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
    const Number code = round_down(Number(point.value.value * Number(16777215.0F) + Number(0.5F)));
    const Number high = round_down(Number(code * Number(1.0F / 65536)));
    const Number rest = code - high * Number(65536);
    const Number middle = round_down(Number(rest * Number(1.0F / 256)));
    const Number low = rest - middle * Number(256);
    return {high / Number(255), middle / Number(255), low / Number(255)};
  }
};

inline double decode(int red, int green, int blue) {
  return (red * 65536.0 + green * 256.0 + blue) / 16777215.0;
}

}  // namespace rasterlab

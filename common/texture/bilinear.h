// Exercise 06.4, second rung: four texels, blended.
#pragma once

#include "common/texture/footprint.h"
#include "common/texture/texel_square.h"

namespace rasterlab {

/// a + part · (b − a): where a and b are equal, exactly that.
template <class Number>
Vector3<Number> blend(const Vector3<Number>& a, const Vector3<Number>& b, const Number& part) {
  const auto channel = [&](int i) { return fused_multiply_add(part, Number(b[i] - a[i]), a[i]); };
  return {channel(0), channel(1), channel(2)};
}

/// The colour, in [0, 1], of a point between the centres of four texels, linear in each direction.
template <class Number>
Vector3<Number> bilinear(const TexelSquare<Number>& square);

/// bilinear() at (u, v) of one level. At the edges the neighbour is what `wrap` says: repeat blends
/// with the opposite edge, clamp and mirror keep the edge's own colour. Cost: four texels.
template <class Number>
Vector3<Number> bilinear_in_level(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                                  const Number& level_index) {
  return visit_square(texture, wrap, uv, level_index,
                      [&](const auto& place, const Number& right, const Number& up) {
                        return bilinear(TexelSquare<Number>{texture.texels(place), right, up});
                      });
}

/// bilinear_in_level() of level 0: smooth near by. The footprint's size still counts for nothing:
/// far off, a pixel blends four of the many texels it sees, which sparkles.
template <class Number>
Vector3<Number> sample_bilinear(const Texture& texture, Wrap wrap,
                                const Footprint<Number>& footprint) {
  return bilinear_in_level(texture, wrap, footprint.uv, Number(0));
}

}  // namespace rasterlab

#include "common/texture/bilinear.inl"

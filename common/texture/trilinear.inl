// Exercise 06.4, fourth rung; the contract is in trilinear.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

// <solution>
/// Of a texture, or of a pair of them.
template <class Textures, class Number>
auto blend_levels(const Textures& textures, Wrap wrap, const Vector2<Number>& uv,
                  const Number& level) {
  const Number finer = round_down(level);
  const Number part = level - finer;
  auto fine = bilinear_in_level(textures, wrap, uv, finer);
  if (!any(part > Number(0))) return fine;
  const Number coarser =
      minimum(finer + Number(1), Number(static_cast<float>(textures.level_count() - 1)));
  return blend(fine, bilinear_in_level(textures, wrap, uv, coarser), part);
}

// </solution>
template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level) {
  // <solution>
  return blend_levels(texture, wrap, uv, level);
  // <starter> throw NotWritten("06.4", texture, wrap, uv, level);
  // </solution>
}

}  // namespace rasterlab

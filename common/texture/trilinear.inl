// Exercise 06.4, fourth rung; the contract is in trilinear.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level) {
  // <solution>
  const Number finer = round_down(level);
  const Number part = level - finer;
  Vector3<Number> fine = bilinear_in_level(texture, wrap, uv, finer);
  if (!any(part > Number(0))) return fine;
  const Number coarser =
      minimum(finer + Number(1), Number(static_cast<float>(texture.level_count() - 1)));
  return blend(fine, bilinear_in_level(texture, wrap, uv, coarser), part);
  // <starter> throw NotWritten("06.4", texture, wrap, uv, level);
  // </solution>
}

}  // namespace rasterlab

// Exercise 06.4, second rung; the contract is in bilinear.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> bilinear_in_level(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                                  const Number& level_index) {
  // <solution>
  const auto level = texture.level(level_index);
  const auto column = texel_pair(uv.x(), level.width, wrap);
  const auto row = texel_pair(uv.y(), level.height, wrap);
  const std::array<Vector3<Number>, 4> texels =
      texture.texels(level, column.first, row.first, wrap);
  const Vector3<Number> lower = blend(texels[0], texels[1], column.part);
  const Vector3<Number> upper = blend(texels[2], texels[3], column.part);
  return blend(lower, upper, row.part) / Number(255);
  // <starter> throw NotWritten("06.4", texture, wrap, uv, level_index);
  // </solution>
}

}  // namespace rasterlab

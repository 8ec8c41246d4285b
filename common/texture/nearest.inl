// Exercise 06.4, first rung; the contract is in nearest.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> sample_nearest(const Texture& texture, Wrap wrap,
                               const Footprint<Number>& footprint) {
  // <solution>
  const auto level = texture.level(Number(0));
  const Number column = texel_index(wrap_coordinate(footprint.uv.x(), wrap), level.width);
  const Number row = texel_index(wrap_coordinate(footprint.uv.y(), wrap), level.height);
  return texture.texel(level, column, row) / Number(255);
  // <starter> throw NotWritten("06.4", texture, wrap, footprint);
  // </solution>
}

}  // namespace rasterlab

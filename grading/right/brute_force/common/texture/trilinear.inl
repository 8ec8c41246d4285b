// A right answer written differently: both levels always, mixed channel by channel.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level) {
  const Number last(static_cast<float>(texture.level_count() - 1));
  const Number below = minimum(round_down(level), last);
  const Number above = minimum(below + Number(1), last);
  const Vector3<Number> fine = bilinear_in_level(texture, wrap, uv, below);
  const Vector3<Number> coarse = bilinear_in_level(texture, wrap, uv, above);
  const Number share = level - below;
  Vector3<Number> mixed;
  for (int i = 0; i < 3; ++i) mixed[i] = fine[i] + share * (coarse[i] - fine[i]);
  return mixed;
}

}  // namespace rasterlab

// Exercise 06.4, first rung: the texel a point lies in.
#pragma once

#include "common/texture/footprint.h"
#include "common/texture/texture.h"
#include "common/texture/wrap.h"

namespace rasterlab {

/// The index of the texel in which a coordinate of [0, 1] lies, of `size` in a row: the far end
/// belongs to the last one.
template <class Number>
Number texel_index(const Number& coordinate, const Number& size) {
  return minimum(round_down(coordinate * size), size - Number(1));
}

/// The colour, in [0, 1], of the texel of level 0 that (u, v) lies in. Cost: one texel.
///
/// A texel owns its left and its lower edge; u = 1 and v = 1 belong to the last. The footprint's
/// size counts for nothing: near by, texels show as squares; far off, a pixel takes one of the many
/// it sees, which sparkles.
template <class Number>
Vector3<Number> sample_nearest(const Texture& texture, Wrap wrap,
                               const Footprint<Number>& footprint);

}  // namespace rasterlab

#include "common/texture/nearest.inl"

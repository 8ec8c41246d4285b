// Exercise 06.1: what a texture coordinate outside [0, 1] means.
#pragma once

#include "common/image/number.h"

namespace rasterlab {

/// How a texture goes on beyond its edges: over and over, with the colour of its edge, or over and
/// over with every second copy mirrored.
enum class Wrap { repeat, clamp, mirror };

/// Takes one texture coordinate, u or v, into [0, 1].
///
/// [0, 1] is the texture itself: what lies in it, both ends included, comes back unchanged in every
/// mode, so that u = 1 names the texture's far edge and never its near one. Outside:
/// - repeat: the distance from the next whole number below, u − ⌊u⌋. Rounding down and not
///   truncation: −0.25 is 0.75.
/// - clamp: the nearer end.
/// - mirror: periodic with period 2 and symmetric about every whole number: 1.25 and −0.75 are
///   0.75.
/// A right answer outside is within 2^-24, half the step of floats just above 1.
/// Just below 0, where u − ⌊u⌋ is nearer to 1 than any float below it, repeat gives 1. −0 counts
/// as 0. From 2^24 on every float is whole: repeat gives 0, mirror 0 or 1. ±∞ clamps to an end and
/// otherwise gives 0; NaN gives 0. Cost: one rounding.
///
/// Runs on any Number (common/image/number.h). Source: A.Q33, B.texture, C.5; the modes are
/// OpenGL 4.6 core, 8.14.2.
template <class Number>
Number wrap_coordinate(const Number& coordinate, Wrap wrap);

/// Takes the index of a texel next to one that is inside, −1 ≤ index ≤ size, to one that is:
/// repeat goes on at the other edge; clamp and mirror stay at this one.
template <class Number>
Number wrap_neighbor(const Number& index, const Number& size, Wrap wrap) {
  const Number last = size - Number(1);
  if (wrap != Wrap::repeat) return minimum(maximum(index, Number(0)), last);
  const Number from_left = select(index < Number(0), last, index);
  return select(from_left > last, Number(0), from_left);
}

}  // namespace rasterlab

#include "common/texture/wrap.inl"

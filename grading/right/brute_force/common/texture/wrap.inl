// A right answer written differently: what lies in the texture comes back first, every mode only
// for the rest.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Number wrap_coordinate(const Number& coordinate, Wrap wrap) {
  const Number zero(0), one(1), two(2);
  Number outside = zero;
  if (wrap == Wrap::clamp) outside = select(coordinate > one, one, zero);
  if (wrap == Wrap::repeat) outside = coordinate - round_down(coordinate);
  if (wrap == Wrap::mirror) {
    const Number below = round_down(coordinate);
    const Number part = coordinate - below;
    const Number half = below / two;
    outside = select(half == round_down(half), part, one - part);
  }
  const Number inside = select(coordinate > zero, coordinate, zero);
  const Number chosen = select(minimum(coordinate, one - coordinate) >= zero, inside, outside);
  return minimum(maximum(chosen, zero), one);
}

}  // namespace rasterlab

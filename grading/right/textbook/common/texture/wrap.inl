// A right answer written differently: mirror as the fold of repeat with a period of 2, clamp first.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Number wrap_coordinate(const Number& coordinate, Wrap wrap) {
  const Number none(0), whole(1);
  const Number clamped = minimum(maximum(coordinate, none), whole);
  if (wrap == Wrap::clamp) return clamped;
  const Number period(wrap == Wrap::mirror ? 2.0F : 1.0F);
  const Number turns = round_down(Number(coordinate / period));
  Number rest = coordinate - turns * period;
  if (wrap == Wrap::mirror) rest = whole - magnitude(Number(rest - whole));
  rest = minimum(maximum(rest, none), whole);
  return select(coordinate == clamped, clamped, rest);
}

}  // namespace rasterlab

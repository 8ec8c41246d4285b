// Exercise 06.1; the contract is in wrap.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Number wrap_coordinate(const Number& coordinate, Wrap wrap) {
  // <solution>
  const Number zero(0);
  const Number one(1);
  Number wrapped = coordinate;
  if (wrap == Wrap::repeat) {
    const Number inside = coordinate - round_down(coordinate);
    wrapped = select(coordinate == one, one, inside);
  } else if (wrap == Wrap::mirror) {
    const Number distance = magnitude(coordinate);
    const Number in_period = distance - Number(2) * round_down(Number(distance * Number(0.5F)));
    wrapped = select(in_period > one, Number(2) - in_period, in_period);
  }
  return minimum(maximum(wrapped, zero), one);  // NaN becomes 0
  // <starter> throw NotWritten("06.1", coordinate, wrap);
  // </solution>
}

}  // namespace rasterlab

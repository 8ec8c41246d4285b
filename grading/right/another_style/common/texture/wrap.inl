// A right answer written differently: each mode by itself, mirror as the distance from the nearest
// even number.
#pragma once

namespace rasterlab {

template <class Number>
Number wrap_coordinate(const Number& coordinate, Wrap wrap) {
  const auto inside = [](const Number& x) -> Number {
    return minimum(maximum(x, Number(0)), Number(1));
  };
  if (wrap == Wrap::clamp) return inside(coordinate);
  if (wrap == Wrap::repeat) {
    const Number below = round_down(coordinate);
    return inside(select(coordinate == Number(1), Number(1), coordinate - below));
  }
  const Number nearest_even =
      Number(2) * round_down(Number(coordinate * Number(0.5F) + Number(0.5F)));
  const Number folded = inside(magnitude(Number(coordinate - nearest_even)));
  return select(inside(coordinate) == coordinate, inside(coordinate), folded);
}

}  // namespace rasterlab

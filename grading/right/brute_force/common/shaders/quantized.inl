// A right answer written differently: every band is asked whether the value has reached it.
#pragma once

namespace rasterlab {

template <class Number>
Number quantize(const Number& value, int levels) {
  Number reached(0);
  for (int band = 1; band < levels; ++band) {
    const Number share(static_cast<float>(band) / static_cast<float>(levels - 1));
    const Number scaled = value * Number(static_cast<float>(levels));
    reached = select(scaled < Number(static_cast<float>(band)), reached, share);
  }
  return select(value > Number(0), reached, Number(0));  // NaN is not above 0
}

}  // namespace rasterlab

// A right answer written differently: counted by thresholds passed.
#pragma once

namespace rasterlab {

template <class Number>
Number quantize(const Number& value, int levels) {
  Number passed(0);
  for (int i = 1; i < levels; ++i) {
    const Number reached = value * Number(static_cast<float>(levels));
    passed = passed + select(reached >= Number(static_cast<float>(i)), Number(1), Number(0));
  }
  return passed / Number(static_cast<float>(levels - 1));
}

}  // namespace rasterlab

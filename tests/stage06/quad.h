// 113-bit arithmetic for what the tests of texturing hold a float to.
#pragma once

#include <cmath>

namespace rasterlab {

__extension__ using Quad = __float128;
__extension__ using Int128 = __int128;

/// Rounded down, for |a| < 2^100.
inline Quad quad_floor(Quad a) {
  const Quad truncated = static_cast<Quad>(static_cast<Int128>(a));
  return truncated > a ? truncated - 1 : truncated;
}

inline double difference(float actual, Quad expected) {
  return std::fabs(static_cast<double>(static_cast<Quad>(actual) - expected));
}

}  // namespace rasterlab

// Random inputs that are the same everywhere: std::uniform_int_distribution differs between
// libraries.
#pragma once

#include <random>

namespace rasterlab::bench {

/// A number in [low, high), in steps of 2^-32 of their distance.
inline double random_number(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 0x1p32);
}

}  // namespace rasterlab::bench

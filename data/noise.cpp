#include "data/noise.h"

#include <cmath>

namespace rasterlab {

double lattice_value(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed) {
  // Multiply and shift until each bit depends on every input.
  std::uint64_t bits = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U;
  bits ^= static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FU + (bits << 6);
  bits ^= static_cast<std::uint64_t>(z) * 0x165667B19E3779F9U + (bits >> 2);
  bits ^= seed * 0xD6E8FEB86659FD93U;
  for (int round = 0; round < 2; ++round) {
    bits ^= bits >> 32;
    bits *= 0xD6E8FEB86659FD93U;
  }
  return static_cast<double>((bits ^ (bits >> 32)) >> 11) * 0x1p-53;
}

double value_noise(const Eigen::Vector3d& place, std::uint32_t seed) {
  const Eigen::Vector3d low = place.array().floor();
  const Eigen::Array3d t = place - low;
  const Eigen::Array3d weight = t * t * t * (t * (t * 6 - 15) + 10);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Array3i bit(corner & 1, corner >> 1 & 1, corner >> 2);
    const Eigen::Array3d share =
        bit.cast<double>() * weight + (1 - bit.cast<double>()) * (1 - weight);
    sum += share.prod() * lattice_value(static_cast<std::int64_t>(low.x()) + bit.x(),
                                        static_cast<std::int64_t>(low.y()) + bit.y(),
                                        static_cast<std::int64_t>(low.z()) + bit.z(), seed);
  }
  return sum;
}

double fractal_noise(const Eigen::Vector3d& place, int octaves, std::uint32_t seed) {
  double sum = 0;
  double strength = 0.5;
  double total = 0;
  Eigen::Vector3d scaled = place;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += strength * value_noise(scaled, seed + 17 * static_cast<std::uint32_t>(octave));
    total += strength;
    strength /= 2;
    scaled = 2 * scaled +
             Eigen::Vector3d(11.3, 5.7, 8.1);  // no two octaves have lattice points in common
  }
  return sum / total;
}

}  // namespace rasterlab

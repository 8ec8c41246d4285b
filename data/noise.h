// Numbers that look random but are a function of the place: K. Perlin, "An Image Synthesizer",
// SIGGRAPH 1985, in the plainer form of values on a lattice.
#pragma once

#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// A number of [0, 1) for each point of the integer lattice and seed.
double lattice_value(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed);

/// Lattice values blended smoothly in between, with a continuous second derivative.
double value_noise(const Eigen::Vector3d& place, std::uint32_t seed);

/// Octaves of noise, each at twice the frequency and half the strength of the one before; in [0,
/// 1], about ½ on average.
double fractal_noise(const Eigen::Vector3d& place, int octaves, std::uint32_t seed);

}  // namespace rasterlab

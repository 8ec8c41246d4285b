#include "bench/lighting/normalisation.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::bench {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

/// Between three unit normals up to 40° from a common one.
Vectors interpolated_normals() {
  std::mt19937 random(7);
  const auto normal = [&random] {
    const double tilt = random_number(random, 0, 40 * std::numbers::pi / 180);
    const double turn = random_number(random, 0, 2 * std::numbers::pi);
    return Eigen::Vector3d(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                           std::cos(tilt));
  };
  Vectors normals(4096);
  for (Eigen::Vector3f& between : normals) {
    const double a = random_number(random, 0, 1);
    const double b = random_number(random, 0, 1 - a);
    between = (a * normal() + b * normal() + (1 - a - b) * normal()).cast<float>();
  }
  return normals;
}

/// 1/√x from the bits of a float, off by up to 3.5 % (J. Blinn, "Floating-point tricks", 1997),
/// then Newton's steps.
template <int Steps>
float estimated_inverse_root(float x) {
  float root = std::bit_cast<float>(0x5F3759DFU - (std::bit_cast<std::uint32_t>(x) >> 1U));
  for (int i = 0; i < Steps; ++i) root *= 1.5F - 0.5F * x * root * root;
  return root;
}

template <class Normalize>
void add(TimedLadder& ladder, const char* name, const char* fault, Normalize normalize) {
  const Vectors normals = interpolated_normals();
  MeasuredError length;
  for (const Eigen::Vector3f& normal : normals) {
    const Eigen::Vector3f unit = normalize(normal);
    const Quad x = unit.x();
    const Quad y = unit.y();
    const Quad z = unit.z();
    length.add(unit.cast<double>().norm() - 1, quad_sqrt(x * x + y * y + z * z) - 1);
  }
  const auto results = std::make_shared<Vectors>(normals.size());
  ladder.rungs.push_back({.name = name,
                          .fault = fault,
                          .work =
                              [normals, results, normalize] {
                                for (std::size_t i = 0; i < normals.size(); ++i)
                                  (*results)[i] = normalize(normals[i]);
                              },
                          .errors = {{"largest error of the length", length.largest()},
                                     {"RMS", length.root_mean_square()}}});
}

}  // namespace

TimedLadder normalisation_ladder() {
  TimedLadder ladder{.name = "normalising an interpolated normal",
                     .stage = "05",
                     .unit = "vector",
                     .units = static_cast<double>(interpolated_normals().size()),
                     .error = "largest error of the length",
                     .rungs = {}};
  using Vector = Eigen::Vector3f;
  add(ladder, "none", "shorter between the corners: highlights darken there",
      [](const Vector& v) -> Vector { return v; });
  add(ladder, "estimate", "3.5 % too long or short",
      [](const Vector& v) -> Vector { return v * estimated_inverse_root<0>(v.squaredNorm()); });
  add(ladder, "estimate, one step", "two parts in 1000",
      [](const Vector& v) -> Vector { return v * estimated_inverse_root<1>(v.squaredNorm()); });
  add(ladder, "estimate, two steps", "a few parts in a million",
      [](const Vector& v) -> Vector { return v * estimated_inverse_root<2>(v.squaredNorm()); });
  add(ladder, "square root, float", "none beyond the last bits",
      [](const Vector& v) -> Vector { return v / std::sqrt(v.squaredNorm()); });
  add(ladder, "square root, double", "none beyond the last bit", [](const Vector& v) -> Vector {
    const Eigen::Vector3d d = v.cast<double>();
    return (d / std::sqrt(d.squaredNorm())).cast<float>();
  });
  return ladder;
}

}  // namespace rasterlab::bench

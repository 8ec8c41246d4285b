#include "bench/lighting/powers.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace rasterlab::bench {
namespace {

/// Cosines, as the highlight raises them: near 1, where it is.
std::vector<float> cosines(int exponent) {
  std::mt19937 random(5);
  std::vector<float> values(4096);
  for (float& value : values) {
    const double lowest = std::pow(0.001, 1.0 / exponent);  // where less than 1/1000 is left
    value = static_cast<float>(random_number(random, lowest, 1));
  }
  return values;
}

/// exp2 and log2 by the float's own exponent and a parabola through the rest.
float rough_log2(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto exponent = static_cast<float>(static_cast<int>(bits >> 23U) - 127);
  const float mantissa = std::bit_cast<float>((bits & 0x7FFFFFU) | 0x3F800000U);
  return exponent + (-0.34484843F * mantissa + 2.02466578F) * mantissa - 1.67487759F;
}

float rough_exp2(float x) {
  const float whole = std::floor(x);
  const float rest = x - whole;
  const float mantissa = (0.33718944F * rest + 0.65763628F) * rest + 1.00172476F;
  return std::ldexp(mantissa, static_cast<int>(whole));
}

float integer_power(float base, int exponent) {
  float power = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 != 0) power *= base;
  }
  return power;
}

/// A table over x from 0 to 1, made for one exponent, straight between its entries.
class Table {
 public:
  explicit Table(int exponent) {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      entries_[i] = static_cast<float>(std::pow(static_cast<double>(i) / size, exponent));
    }
  }

  float operator()(float x) const {
    const float place = x * size;
    const auto index = std::min(static_cast<std::size_t>(place), entries_.size() - 2);
    const float part = place - static_cast<float>(index);
    return entries_[index] + part * (entries_[index + 1] - entries_[index]);
  }

 private:
  static constexpr int size = 256;
  std::array<float, size + 1> entries_{};
};

/// Adds a way, timed and judged on the same cosines.
template <class Power>
void add(TimedLadder& ladder, const char* name, const char* fault, int exponent, Power power) {
  const std::vector<float> values = cosines(exponent);
  MeasuredError codes;
  MeasuredError relative;
  for (const float x : values) {
    const float computed = power(x);
    const double by_double = std::pow(double{x}, exponent);
    const Quad by_quad = quad_power(x, exponent);
    codes.add(255 * (computed - by_double), 255 * (computed - by_quad));
    relative.add(computed / by_double - 1, computed / by_quad - 1);
  }
  const auto results = std::make_shared<std::vector<float>>(values.size());
  ladder.rungs.push_back({.name = name,
                          .fault = fault,
                          .work =
                              [values, results, power] {
                                for (std::size_t i = 0; i < values.size(); ++i)
                                  (*results)[i] = power(values[i]);
                              },
                          .errors = {{"largest error in codes of 255", codes.largest()},
                                     {"RMS in codes", codes.root_mean_square()},
                                     {"largest relative", relative.largest()}}});
}

}  // namespace

TimedLadder power_ladder(int exponent) {
  TimedLadder ladder{.name = "power " + std::to_string(exponent) + " of the highlight",
                     .stage = "05",
                     .unit = "power",
                     .units = static_cast<double>(cosines(exponent).size()),
                     .error = "largest error in codes of 255",
                     .rungs = {}};
  const auto real = static_cast<float>(exponent);
  add(ladder, "rough exp2 of log2", "a parabola each for exp2 and log2: useless for high powers",
      exponent, [real](float x) { return rough_exp2(real * rough_log2(x)); });
  add(ladder, "table of 256", "straight between its entries", exponent, Table(exponent));
  add(ladder, "exp2 of log2", "a few times the last bit", exponent,
      [real](float x) { return std::exp2(real * std::log2(x)); });
  add(ladder, "integer power", "whole exponents only; rounds at every product", exponent,
      [exponent](float x) { return integer_power(x, exponent); });
  add(ladder, "std::pow of float", "none beyond the last bit", exponent,
      [real](float x) { return std::pow(x, real); });
  add(ladder, "std::pow of double", "none beyond the last bit", exponent, [exponent](float x) {
    return static_cast<float>(std::pow(double{x}, double{static_cast<float>(exponent)}));
  });
  return ladder;
}

}  // namespace rasterlab::bench

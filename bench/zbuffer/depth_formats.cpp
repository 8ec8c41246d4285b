#include "bench/zbuffer/depth_formats.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace rasterlab::bench {
namespace {

constexpr double near = 0.1;
constexpr double far = 2e5;

/// Two points on one line of sight.
struct Pair {
  float nearer;
  float farther;
};

/// As many in every decade from 1 to 100 000; where floats cannot tell so little apart, the next
/// float.
std::vector<Pair> make_pairs(double apart) {
  std::mt19937 random(19);
  std::vector<Pair> pairs(1 << 14);
  for (Pair& pair : pairs) {
    const double distance = std::pow(10, random_number(random, 0, 5));
    pair.nearer = static_cast<float>(distance);
    pair.farther = std::max(static_cast<float>(distance * (1 + apart)),
                            std::nextafter(pair.nearer, std::numeric_limits<float>::max()));
  }
  return pairs;
}

/// Clip coordinates z = scale · distance + offset and w = distance, divided: what a projection
/// matrix makes of a distance, linear in 1/distance.
struct Projection {
  double scale;
  double offset;

  float operator()(float distance) const {
    return (static_cast<float>(scale) * distance + static_cast<float>(offset)) / distance;
  }
  template <class Number>
  Number exactly(Number distance) const {
    return Number(scale) + Number(offset) / distance;
  }
};

// NDC z from −1 near to 1 far, or, reversed, from 1 near to 0 far.
constexpr Projection standard{(far + near) / (far - near), -2 * far* near / (far - near)};
constexpr Projection standard_infinite{1, -2 * near};
constexpr Projection reversed{-near / (far - near), far* near / (far - near)};
constexpr Projection reversed_infinite{0, near};

/// NDC z from [−1, 1] to [0, 1], and the nearest of 2^bits codes.
template <int bits>
struct Unorm {
  static constexpr double largest = (1U << bits) - 1U;
  static double store(float z) { return std::nearbyint((0.5 * double{z} + 0.5) * largest); }
  template <class Number>
  static Number exactly(Number z) {
    return (z / 2 + Number(0.5)) * Number(largest);
  }
  static double last_place(double) { return 1; }
};

struct Float {
  static double store(float z) { return double{z}; }
  template <class Number>
  static Number exactly(Number z) {
    return z;
  }
  static double last_place(double value) {
    return std::ldexp(1.0, std::max(std::ilogb(value), -126) - 23);
  }
};

/// From a standard z: the far plane becomes 0, but its digits are gone.
struct TurnedFloat : Float {
  static double store(float z) { return double{0.5F - 0.5F * z}; }
  template <class Number>
  static Number exactly(Number z) {
    return (1 - z) / 2;
  }
};

template <class Format>
Errors errors_of(const std::vector<Pair>& pairs, const Projection& projection) {
  MeasuredError places;
  double wrong = 0;
  double ties = 0;
  for (const Pair& pair : pairs) {
    const double nearer = Format::store(projection(pair.nearer));
    const double farther = Format::store(projection(pair.farther));
    const double by_double = Format::exactly(projection.exactly(double{pair.nearer}));
    const Quad by_quad = Format::exactly(projection.exactly(Quad{pair.nearer}));
    const double place = Format::last_place(static_cast<double>(by_quad));
    places.add((nearer - by_double) / place, (Quad{nearer} - by_quad) / place);
    const bool grows = Format::exactly(projection.exactly(Quad{pair.farther})) > by_quad;
    wrong += (grows ? farther < nearer : farther > nearer) ? 1 : 0;
    ties += farther == nearer ? 1 : 0;
  }
  const double scale = 1e6 / static_cast<double>(pairs.size());
  return {{"wrong + ties per million", scale * (wrong + ties)},
          {"wrong order per million", scale * wrong},
          {"ties per million", scale * ties},
          {"largest, ULP", places.largest()}};
}

template <class Format>
void add(TimedLadder& ladder, const std::vector<Pair>& pairs, const char* name, const char* fault,
         const Projection& projection, Format) {
  const auto stored = std::make_shared<std::vector<double>>(2 * pairs.size());
  ladder.rungs.push_back({.name = name,
                          .fault = fault,
                          .work =
                              [pairs, stored, projection] {
                                double* to = stored->data();
                                for (const Pair& pair : pairs) {
                                  *to++ = Format::store(projection(pair.nearer));
                                  *to++ = Format::store(projection(pair.farther));
                                }
                              },
                          .errors = errors_of<Format>(pairs, projection)});
}

}  // namespace

TimedLadder depth_format_ladder(double apart) {
  const std::vector<Pair> pairs = make_pairs(apart);
  char name[80];
  std::snprintf(name, sizeof name, "depth formats, pairs %.0e of their distance apart", apart);
  TimedLadder ladder{.name = name,
                     .stage = "03",
                     .unit = "depth",
                     .units = 2.0 * static_cast<double>(pairs.size()),
                     .error = "wrong + ties per million",
                     .rungs = {}};
  add(ladder, pairs, "UNORM16", "few steps, and most of them near by", standard, Unorm<16>());
  add(ladder, pairs, "UNORM24", "few steps far off", standard, Unorm<24>());
  add(ladder, pairs, "float, turned afterwards", "what is lost stays lost", standard,
      TurnedFloat());
  add(ladder, pairs, "float", "crowds the far end twice: by 1/z and by the float", standard,
      Float());
  add(ladder, pairs, "float, far at infinity", "as float", standard_infinite, Float());
  add(ladder, pairs, "reversed float", "loses digits near the far plane, where z nears 0", reversed,
      Float());
  add(ladder, pairs, "reversed float, infinite", "none beyond the last bits", reversed_infinite,
      Float());
  return ladder;
}

}  // namespace rasterlab::bench

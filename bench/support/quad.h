// The oracle of the ladders about numbers: 113 bits of precision, by the compiler alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlab::bench {

__extension__ using Quad = __float128;

inline Quad quad_abs(Quad value) {
  return value < 0 ? -value : value;
}

/// The square root: a double's, made better by two of Newton's steps, each of which doubles the
/// digits.
inline Quad quad_sqrt(Quad value) {
  if (value <= 0) return 0;
  Quad root = std::sqrt(static_cast<double>(value));
  for (int i = 0; i < 2; ++i) root = (root + value / root) / 2;
  return root;
}

/// base^exponent by squaring; exponent ≥ 0.
inline Quad quad_power(Quad base, int exponent) {
  Quad power = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 != 0) power *= base;
  }
  return power;
}

/// The largest and the root of the mean square of many errors, against an oracle in doubles and one
/// in quads. A figure counts only where the two oracles agree to a thousandth of it; else it is not
/// a number.
class MeasuredError {
 public:
  /// An error as either oracle has it.
  void add(double by_double, Quad by_quad) {
    largest_double_ = std::max(largest_double_, std::abs(by_double));
    largest_quad_ = std::max(largest_quad_, quad_abs(by_quad));
    squares_double_ += by_double * by_double;
    squares_quad_ += by_quad * by_quad;
    ++count_;
  }

  double largest() const { return agreed(largest_double_, largest_quad_); }
  double root_mean_square() const {
    return agreed(std::sqrt(squares_double_ / count_), quad_sqrt(squares_quad_ / count_));
  }

 private:
  static double agreed(double by_double, Quad by_quad) {
    const auto value = static_cast<double>(by_quad);
    const bool agree = std::abs(by_double - value) <= 1e-3 * value;
    return agree ? value : std::numeric_limits<double>::quiet_NaN();
  }

  double largest_double_ = 0;
  Quad largest_quad_ = 0;
  double squares_double_ = 0;
  Quad squares_quad_ = 0;
  int count_ = 0;
};

}  // namespace rasterlab::bench

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

/// Rounded down; for |value| < 2^62.
inline Quad quad_floor(Quad value) {
  const auto whole = static_cast<Quad>(static_cast<long long>(value));
  return whole > value ? whole - 1 : whole;
}

inline constexpr Quad ln_2 =
    Quad(0x1.62e42fefa39efp-1) + Quad(0x1.abc9e3b39803fp-56) + Quad(0x1.7b57a079a1934p-111);

/// log₂(value) for value > 0: the double's exponent, and a series for the rest, which is within
/// [1/√2, √2]: ln m = 2·artanh((m − 1)/(m + 1)).
inline Quad quad_log2(Quad value) {
  int exponent = 0;
  const double mantissa = std::frexp(static_cast<double>(value), &exponent);
  if (mantissa < 0.70710678) --exponent;
  const Quad m = exponent > 0 ? value / quad_power(2, exponent) : value * quad_power(2, -exponent);
  const Quad s = (m - 1) / (m + 1);
  Quad sum = 0;
  for (int i = 45; i >= 1; i -= 2) sum = sum * s * s + 1 / Quad(i);
  return exponent + 2 * s * sum / ln_2;
}

/// 2^value: a whole power, and a series for the rest.
inline Quad quad_exp2(Quad value) {
  const Quad whole = quad_floor(value);
  const Quad rest = (value - whole) * ln_2;
  Quad sum = 1;
  for (int i = 30; i >= 1; --i) sum = 1 + sum * rest / i;
  const int exponent = static_cast<int>(whole);
  return exponent < 0 ? sum / quad_power(2, -exponent) : sum * quad_power(2, exponent);
}

/// A figure as two oracles have it: the quads', where the doubles' is within a thousandth of it;
/// else not a number, since then doubles cannot tell it and nothing vouches for the quads.
inline double agreed(double by_double, Quad by_quad) {
  const auto value = static_cast<double>(by_quad);
  const bool agree = std::abs(by_double - value) <= 1e-3 * std::abs(value);
  return agree ? value : std::numeric_limits<double>::quiet_NaN();
}

/// What many errors come to, against an oracle in doubles and one in quads. A figure counts only
/// where the two have agreed.
class MeasuredError {
 public:
  /// An error as either oracle has it.
  void add(double by_double, Quad by_quad) {
    largest_double_ = std::max(largest_double_, std::abs(by_double));
    largest_quad_ = std::max(largest_quad_, quad_abs(by_quad));
    sum_double_ += std::abs(by_double);
    sum_quad_ += quad_abs(by_quad);
    squares_double_ += by_double * by_double;
    squares_quad_ += by_quad * by_quad;
    ++count_;
  }

  double largest() const { return agreed(largest_double_, largest_quad_); }
  double mean() const { return agreed(sum_double_ / count_, sum_quad_ / count_); }
  double root_mean_square() const {
    return agreed(std::sqrt(squares_double_ / count_), quad_sqrt(squares_quad_ / count_));
  }

 private:
  double largest_double_ = 0;
  Quad largest_quad_ = 0;
  double sum_double_ = 0;
  Quad sum_quad_ = 0;
  double squares_double_ = 0;
  Quad squares_quad_ = 0;
  int count_ = 0;
};

}  // namespace rasterlab::bench

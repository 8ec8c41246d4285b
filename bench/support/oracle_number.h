// What code for any Number (common/image/number.h) means: the same code run on doubles and on
// quads.
#pragma once

#include "common/image/number.h"

#include "bench/support/quad.h"

#include <cmath>
#include <concepts>
#include <cstdint>

namespace rasterlab::bench {

/// A Number that holds a double or a Quad.
template <class Scalar>
struct OracleNumber {
  Scalar value = 0;

  OracleNumber() = default;
  OracleNumber(float number) : value(number) {}
  template <std::same_as<Scalar> Same>
  explicit OracleNumber(Same number) : value(number) {}

  friend OracleNumber operator+(OracleNumber a, OracleNumber b) {
    return OracleNumber(Scalar(a.value + b.value));
  }
  friend OracleNumber operator-(OracleNumber a, OracleNumber b) {
    return OracleNumber(Scalar(a.value - b.value));
  }
  friend OracleNumber operator*(OracleNumber a, OracleNumber b) {
    return OracleNumber(Scalar(a.value * b.value));
  }
  friend OracleNumber operator/(OracleNumber a, OracleNumber b) {
    return OracleNumber(Scalar(a.value / b.value));
  }
  friend OracleNumber operator-(OracleNumber a) { return OracleNumber(Scalar(-a.value)); }
  OracleNumber& operator+=(OracleNumber b) { return *this = *this + b; }
  OracleNumber& operator-=(OracleNumber b) { return *this = *this - b; }
  OracleNumber& operator*=(OracleNumber b) { return *this = *this * b; }
  OracleNumber& operator/=(OracleNumber b) { return *this = *this / b; }
  friend bool operator<(OracleNumber a, OracleNumber b) { return a.value < b.value; }
  friend bool operator<=(OracleNumber a, OracleNumber b) { return a.value <= b.value; }
  friend bool operator>(OracleNumber a, OracleNumber b) { return a.value > b.value; }
  friend bool operator>=(OracleNumber a, OracleNumber b) { return a.value >= b.value; }
  friend bool operator==(OracleNumber a, OracleNumber b) { return a.value == b.value; }
};

// The mathematics of either, by one name.
inline double root_of(double value) {
  return std::sqrt(value);
}
inline Quad root_of(Quad value) {
  return quad_sqrt(value);
}
inline double floor_of(double value) {
  return std::floor(value);
}
inline Quad floor_of(Quad value) {
  return quad_floor(value);
}
inline double log2_of(double value) {
  return std::log2(value);
}
inline Quad log2_of(Quad value) {
  return quad_log2(value);
}
inline double power_of(double base, double exponent) {
  return std::pow(base, exponent);
}
inline Quad power_of(Quad base, Quad exponent) {
  return base > 0 ? quad_exp2(exponent * quad_log2(base)) : Quad(exponent > 0 ? 0 : 1);
}

template <class Scalar>
OracleNumber<Scalar> select(bool condition, OracleNumber<Scalar> if_true,
                            OracleNumber<Scalar> if_false) {
  return condition ? if_true : if_false;
}
template <class Scalar>
OracleNumber<Scalar> minimum(OracleNumber<Scalar> a, OracleNumber<Scalar> b) {
  return a < b ? a : b;
}
template <class Scalar>
OracleNumber<Scalar> maximum(OracleNumber<Scalar> a, OracleNumber<Scalar> b) {
  return a > b ? a : b;
}
template <class Scalar>
OracleNumber<Scalar> magnitude(OracleNumber<Scalar> a) {
  return a.value < 0 ? -a : a;
}
template <class Scalar>
OracleNumber<Scalar> fused_multiply_add(OracleNumber<Scalar> a, OracleNumber<Scalar> b,
                                        OracleNumber<Scalar> c) {
  return a * b + c;
}
template <class Scalar>
OracleNumber<Scalar> square_root(OracleNumber<Scalar> a) {
  return OracleNumber<Scalar>(root_of(a.value));
}
template <class Scalar>
OracleNumber<Scalar> round_down(OracleNumber<Scalar> a) {
  return OracleNumber<Scalar>(floor_of(a.value));
}
template <class Scalar>
OracleNumber<Scalar> log_2(OracleNumber<Scalar> a) {
  return OracleNumber<Scalar>(log2_of(a.value));
}
template <class Scalar>
OracleNumber<Scalar> power(OracleNumber<Scalar> base, OracleNumber<Scalar> exponent) {
  return OracleNumber<Scalar>(power_of(base.value, exponent.value));
}
template <class Scalar>
OracleNumber<Scalar> power(OracleNumber<Scalar> base, float exponent) {
  return power(base, OracleNumber<Scalar>(exponent));
}

template <class Element, class Scalar>
OracleNumber<Scalar> gather(const Element* array, OracleNumber<Scalar> index) {
  return static_cast<float>(array[static_cast<std::int32_t>(index.value)]);
}

/// An index, and which oracle what it fetches is for.
template <class Scalar>
struct OracleIndex {
  std::int32_t value = 0;
  friend OracleIndex operator+(OracleIndex a, OracleIndex b) { return {a.value + b.value}; }
  friend OracleIndex operator*(OracleIndex a, OracleIndex b) { return {a.value * b.value}; }
};
template <class Scalar>
OracleIndex<Scalar> to_whole(OracleNumber<Scalar> a) {
  return {static_cast<std::int32_t>(a.value)};
}
template <class Scalar>
Vector3<OracleNumber<Scalar>> gather_texel(const TexelAndAbove* texels, OracleIndex<Scalar> index) {
  return broadcast<OracleNumber<Scalar>>(rasterlab::gather_texel(texels, index.value));
}

}  // namespace rasterlab::bench

namespace Eigen {
template <class Scalar>
struct NumTraits<rasterlab::bench::OracleNumber<Scalar>> : GenericNumTraits<double> {
  using Real = rasterlab::bench::OracleNumber<Scalar>;
  using NonInteger = rasterlab::bench::OracleNumber<Scalar>;
  using Nested = rasterlab::bench::OracleNumber<Scalar>;
  using Literal = float;
  enum { RequireInitialization = 1, IsComplex = 0, IsInteger = 0, IsSigned = 1 };
};
}  // namespace Eigen

// The number that shading computes with: one float in the exercise code, a SIMD vector of floats in the engine.
//
// A function that should run on both is a template over Number. It computes with + − · / and comparisons, whose result
// is a mask (`bool` for a float), takes these functions unqualified so that each number type brings its own, and
// branches only through select() and any().
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace rasterlab {

template <class Number>
using Vector2 = Eigen::Matrix<Number, 2, 1>;
template <class Number>
using Vector3 = Eigen::Matrix<Number, 3, 1>;
template <class Number>
using Vector4 = Eigen::Matrix<Number, 4, 1>;

/// What comparing two Numbers gives: bool, or one truth value per lane.
template <class Number>
using Mask = decltype(Number() < Number());

inline float select(bool condition, float if_true, float if_false) { return condition ? if_true : if_false; }
inline bool any(bool condition) { return condition; }
inline bool all(bool condition) { return condition; }

/// The smaller and the larger; when either is NaN, b.
inline float minimum(float a, float b) { return a < b ? a : b; }
inline float maximum(float a, float b) { return a > b ? a : b; }
inline float square_root(float a) { return std::sqrt(a); }
inline float round_down(float a) { return std::floor(a); }
inline float magnitude(float a) { return std::fabs(a); }

/// base^exponent for base ≥ 0.
inline float power(float base, float exponent) { return std::pow(base, exponent); }
inline float log_2(float a) { return std::log2(a); }

/// Element `index` of an array; each lane its own. The caller keeps indices inside; an index is a whole number in a
/// Number, exact to 2^24.
template <class Element>
float gather(const Element* array, float index) {
  return static_cast<float>(array[static_cast<int>(index)]);
}

/// A vector of every Number type: a select per component.
template <class Number, int Rows>
Eigen::Matrix<Number, Rows, 1> select(const Mask<Number>& condition, const Eigen::Matrix<Number, Rows, 1>& if_true,
                                      const Eigen::Matrix<Number, Rows, 1>& if_false) {
  Eigen::Matrix<Number, Rows, 1> result;
  for (int i = 0; i < Rows; ++i) result[i] = select(condition, if_true[i], if_false[i]);
  return result;
}

}  // namespace rasterlab

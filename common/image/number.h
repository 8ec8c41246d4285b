// The number that shading computes with: one float in the exercise code, a SIMD vector of floats in
// the engine.
//
// A function that should run on both is a template over Number. It computes with + − · / and
// comparisons, whose result is a mask (`bool` for a float), takes these functions unqualified so
// that each number type brings its own, and branches only through select() and any().
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

inline float select(bool condition, float if_true, float if_false) {
  return condition ? if_true : if_false;
}
inline bool any(bool condition) {
  return condition;
}
inline bool all(bool condition) {
  return condition;
}

/// The smaller and the larger; when either is NaN, b.
inline float minimum(float a, float b) {
  return a < b ? a : b;
}
inline float maximum(float a, float b) {
  return a > b ? a : b;
}
inline float square_root(float a) {
  return std::sqrt(a);
}
inline float round_down(float a) {
  return std::floor(a);
}
inline float magnitude(float a) {
  return std::fabs(a);
}

/// a · b + c, rounded once: by an instruction where the processor has one, and everywhere the same.
inline float fused_multiply_add(float a, float b, float c) {
  return std::fma(a, b, c);
}

/// base^exponent for base ≥ 0. With a float for exponent, if whole, wide numbers are quicker.
inline float power(float base, float exponent) {
  return std::pow(base, exponent);
}
inline float log_2(float a) {
  return std::log2(a);
}

/// Element `index` of an array; each lane its own. The caller keeps indices inside; an index is a
/// whole number in a Number, exact to 2^24.
template <class Element>
float gather(const Element* array, float index) {
  return static_cast<float>(array[static_cast<int>(index)]);
}

/// Element `index` of a small table.
template <class Number, std::size_t Size>
Number gather(const std::array<float, Size>& table, const Number& index) {
  return gather(table.data(), index);
}

/// A Number that is whole and within ±2^31, as an index into something large.
inline std::int32_t to_whole(float a) {
  return static_cast<std::int32_t>(a);
}

/// What to_whole() gives: an integer, or one per lane. Has + and *.
template <class Number>
using Whole = decltype(to_whole(Number()));

/// A packed colour (pack_texel()) and the one above it in its picture.
struct TexelAndAbove {
  std::uint32_t texel;
  std::uint32_t above;
};

/// Red, green and blue, as numbers 0…255, of texel `index` of an array.
inline Vector3<float> gather_texel(const TexelAndAbove* texels, std::int32_t index) {
  const std::uint32_t texel = texels[index].texel;
  return {static_cast<float>(texel & 255U), static_cast<float>(texel >> 8U & 255U),
          static_cast<float>(texel >> 16U & 255U)};
}

/// Red in the lowest byte, then green, then blue.
inline std::uint32_t pack_texel(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  return static_cast<std::uint32_t>(red) | static_cast<std::uint32_t>(green) << 8U |
         static_cast<std::uint32_t>(blue) << 16U;
}

/// The same vector in every lane.
template <class Number>
Vector3<Number> broadcast(const Eigen::Vector3f& vector) {
  return {Number(vector.x()), Number(vector.y()), Number(vector.z())};
}

template <class Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}

template <class Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// matrix · vector, the matrix being the same in every lane.
template <class Number>
Vector3<Number> multiply(const Eigen::Matrix3f& matrix, const Vector3<Number>& vector) {
  return {dot(broadcast<Number>(matrix.row(0)), vector),
          dot(broadcast<Number>(matrix.row(1)), vector),
          dot(broadcast<Number>(matrix.row(2)), vector)};
}

/// The vector divided by its length; where that is zero, the zero vector.
template <class Number>
Vector3<Number> normalized(const Vector3<Number>& vector) {
  const Number squared = dot(vector, vector);
  const Number inverse = select(squared > Number(0), Number(1) / square_root(squared), Number(0));
  return {vector.x() * inverse, vector.y() * inverse, vector.z() * inverse};
}

/// A vector of every Number type: a select per component.
template <class Number, int Rows>
Eigen::Matrix<Number, Rows, 1> select(const Mask<Number>& condition,
                                      const Eigen::Matrix<Number, Rows, 1>& if_true,
                                      const Eigen::Matrix<Number, Rows, 1>& if_false) {
  Eigen::Matrix<Number, Rows, 1> result;
  for (int i = 0; i < Rows; ++i) result[i] = select(condition, if_true[i], if_false[i]);
  return result;
}

}  // namespace rasterlab

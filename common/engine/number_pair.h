// Two vectors side by side: the Number that shaders run on in the engine.
//
// A shader is a long chain of operations, each waiting for the one before, and about as long as
// what a processor looks ahead. With two of them, operation by operation in turn, there is
// something to do while one waits.
#pragma once

#include "common/engine/simd.h"

namespace rasterlab::RASTERLAB_SIMD {

struct TruthPair {
  Truth low, high;

  friend TruthPair operator&&(TruthPair a, TruthPair b) {
    return {a.low && b.low, a.high && b.high};
  }
  friend TruthPair operator||(TruthPair a, TruthPair b) {
    return {a.low || b.low, a.high || b.high};
  }
  friend TruthPair operator!(TruthPair a) { return {!a.low, !a.high}; }
};

struct IntPair {
  Ints low, high;

  friend IntPair operator+(IntPair a, IntPair b) { return {a.low + b.low, a.high + b.high}; }
  friend IntPair operator*(IntPair a, IntPair b) { return {a.low * b.low, a.high * b.high}; }
};

struct NumberPair {
  Number low, high;

  NumberPair() = default;
  NumberPair(float value) : low(value), high(value) {}
  NumberPair(Number l, Number h) : low(l), high(h) {}

  friend NumberPair operator+(NumberPair a, NumberPair b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend NumberPair operator-(NumberPair a, NumberPair b) {
    return {a.low - b.low, a.high - b.high};
  }
  friend NumberPair operator*(NumberPair a, NumberPair b) {
    return {a.low * b.low, a.high * b.high};
  }
  friend NumberPair operator/(NumberPair a, NumberPair b) {
    return {a.low / b.low, a.high / b.high};
  }
  friend NumberPair operator-(NumberPair a) { return {-a.low, -a.high}; }
  NumberPair& operator+=(NumberPair b) { return *this = *this + b; }
  NumberPair& operator-=(NumberPair b) { return *this = *this - b; }
  NumberPair& operator*=(NumberPair b) { return *this = *this * b; }
  NumberPair& operator/=(NumberPair b) { return *this = *this / b; }
  friend TruthPair operator<(NumberPair a, NumberPair b) {
    return {a.low < b.low, a.high < b.high};
  }
  friend TruthPair operator<=(NumberPair a, NumberPair b) {
    return {a.low <= b.low, a.high <= b.high};
  }
  friend TruthPair operator>(NumberPair a, NumberPair b) { return b < a; }
  friend TruthPair operator>=(NumberPair a, NumberPair b) { return b <= a; }
  friend TruthPair operator==(NumberPair a, NumberPair b) {
    return {a.low == b.low, a.high == b.high};
  }
  friend TruthPair operator!=(NumberPair a, NumberPair b) { return !(a == b); }
};

}  // namespace rasterlab::RASTERLAB_SIMD

namespace Eigen {
template <>
struct NumTraits<rasterlab::RASTERLAB_SIMD::NumberPair> : GenericNumTraits<float> {
  using Real = rasterlab::RASTERLAB_SIMD::NumberPair;
  using NonInteger = rasterlab::RASTERLAB_SIMD::NumberPair;
  using Nested = rasterlab::RASTERLAB_SIMD::NumberPair;
  using Literal = float;
  enum { RequireInitialization = 0, IsComplex = 0, IsInteger = 0, IsSigned = 1 };
};
/// A vector of NumberPairs may be scaled by a plain float.
template <class Operation>
struct ScalarBinaryOpTraits<rasterlab::RASTERLAB_SIMD::NumberPair, float, Operation> {
  using ReturnType = rasterlab::RASTERLAB_SIMD::NumberPair;
};
template <class Operation>
struct ScalarBinaryOpTraits<float, rasterlab::RASTERLAB_SIMD::NumberPair, Operation> {
  using ReturnType = rasterlab::RASTERLAB_SIMD::NumberPair;
};
namespace internal {
/// As aligned as the vectors themselves, which Eigen's own limit of 16 bytes would contradict.
template <int Size>
struct compute_default_alignment<rasterlab::RASTERLAB_SIMD::NumberPair, Size> {
  enum { value = 0 };
};
}  // namespace internal
}  // namespace Eigen

namespace rasterlab::RASTERLAB_SIMD {

// What number.h says of a Number, of each half.

inline bool any(TruthPair a) {
  return any(a.low) || any(a.high);
}
inline bool all(TruthPair a) {
  return all(a.low) && all(a.high);
}
inline NumberPair select(TruthPair condition, NumberPair if_true, NumberPair if_false) {
  return {select(condition.low, if_true.low, if_false.low),
          select(condition.high, if_true.high, if_false.high)};
}
inline TruthPair select(TruthPair condition, TruthPair if_true, TruthPair if_false) {
  return (condition && if_true) || (!condition && if_false);
}
inline NumberPair minimum(NumberPair a, NumberPair b) {
  return {minimum(a.low, b.low), minimum(a.high, b.high)};
}
inline NumberPair maximum(NumberPair a, NumberPair b) {
  return {maximum(a.low, b.low), maximum(a.high, b.high)};
}
inline NumberPair square_root(NumberPair a) {
  return {square_root(a.low), square_root(a.high)};
}
inline NumberPair magnitude(NumberPair a) {
  return {magnitude(a.low), magnitude(a.high)};
}
inline NumberPair fused_multiply_add(NumberPair a, NumberPair b, NumberPair c) {
  return {fused_multiply_add(a.low, b.low, c.low), fused_multiply_add(a.high, b.high, c.high)};
}
inline NumberPair round_down(NumberPair a) {
  return {round_down(a.low), round_down(a.high)};
}
inline NumberPair log_2(NumberPair a) {
  return {log_2(a.low), log_2(a.high)};
}
inline NumberPair power(NumberPair base, NumberPair exponent) {
  return {power(base.low, exponent.low), power(base.high, exponent.high)};
}
inline NumberPair power(NumberPair base, float exponent) {
  if (is_small_and_whole(exponent)) return power_by_squaring(base, static_cast<int>(exponent));
  return power(base, NumberPair(exponent));
}
inline IntPair to_whole(NumberPair a) {
  return {to_whole(a.low), to_whole(a.high)};
}
template <class Element>
NumberPair gather(const Element* array, NumberPair index) {
  return {gather(array, index.low), gather(array, index.high)};
}
inline NumberPair gather(const std::array<float, 16>& table, NumberPair index) {
  return {gather(table, index.low), gather(table, index.high)};
}

inline Vector3<NumberPair> join(const Vector3<Number>& low, const Vector3<Number>& high) {
  return {{low.x(), high.x()}, {low.y(), high.y()}, {low.z(), high.z()}};
}
inline Vector3<NumberPair> gather_texel(const TexelAndAbove* texels, IntPair index) {
  return join(gather_texel(texels, index.low), gather_texel(texels, index.high));
}
inline std::array<Vector3<NumberPair>, 4> gather_square(const TexelAndAbove* texels,
                                                        IntPair index) {
  const auto low = gather_square(texels, index.low);
  const auto high = gather_square(texels, index.high);
  return {join(low[0], high[0]), join(low[1], high[1]), join(low[2], high[2]),
          join(low[3], high[3])};
}
#if HWY_TARGET == HWY_AVX3
struct NearSquarePairs {
  bool found;
  std::ptrdiff_t low_corner, high_corner;
  Ints low, high;  ///< the first ones
};

/// All of them near one another, as most often, or those of each half.
inline NearSquarePairs find_near_squares(int width, int height, NumberPair left, NumberPair low) {
  const MiddleLane middle(left.high, low.high);
  const FromMiddle of_high(middle, left.high, low.high);
  if (!middle.is_inside(width, height) || !of_high.are_near()) return {};
  const FromMiddle of_low(middle, left.low, low.low);
  const std::ptrdiff_t corner = middle.corner(width);
  if (of_low.are_near()) return {true, corner, corner, of_low.first(), of_high.first()};
  const NearSquares own = find_near_squares(width, height, left.low, low.low);
  return {own.found, own.corner, corner, own.first, of_high.first()};
}

inline std::array<Vector3<NumberPair>, 4> gather_near_squares(const TexelAndAbove* texels,
                                                              int width,
                                                              const NearSquarePairs& squares) {
  NearTexels near(texels + squares.low_corner, width);
  const auto low = near.squares(squares.low);
  if (squares.low_corner != squares.high_corner) {
    near = NearTexels(texels + squares.high_corner, width);
  }
  const auto high = near.squares(squares.high);
  return {join(low[0], high[0]), join(low[1], high[1]), join(low[2], high[2]),
          join(low[3], high[3])};
}
#endif

}  // namespace rasterlab::RASTERLAB_SIMD

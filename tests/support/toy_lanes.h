// The simplest wide Number: a few floats side by side, each computed as a float would be. What runs
// on it runs in the engine, and must give each lane the bits that one float gives.
#pragma once

#include "common/image/number.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rasterlab {

template <int Lanes>
struct ToyMask {
  std::array<bool, Lanes> lane{};
};

template <int Lanes>
struct ToyWhole {
  std::array<std::int32_t, Lanes> lane{};
};

template <int Lanes>
struct ToyLanes {
  std::array<float, Lanes> lane{};

  ToyLanes() = default;
  ToyLanes(float value) { lane.fill(value); }  // NOLINT: as a float turns into a Number
};

/// Calls `compute` for each lane and collects what it gives.
template <class Result, int Lanes, class Compute>
Result per_lane(Compute compute) {
  Result result;
  for (std::size_t i = 0; i < Lanes; ++i) result.lane[i] = compute(i);
  return result;
}

// NOLINTBEGIN(bugprone-macro-parentheses): templates' names stand in no parentheses.
#define RASTERLAB_TOY_OPERATOR(op, Operand, Result)                                               \
  template <int Lanes>                                                                            \
  Result<Lanes> operator op(const Operand<Lanes>& a, const Operand<Lanes>& b) {                   \
    return per_lane<Result<Lanes>, Lanes>([&](std::size_t i) { return a.lane[i] op b.lane[i]; }); \
  }
// NOLINTEND(bugprone-macro-parentheses)
RASTERLAB_TOY_OPERATOR(+, ToyLanes, ToyLanes)
RASTERLAB_TOY_OPERATOR(-, ToyLanes, ToyLanes)
RASTERLAB_TOY_OPERATOR(*, ToyLanes, ToyLanes)
RASTERLAB_TOY_OPERATOR(/, ToyLanes, ToyLanes)
RASTERLAB_TOY_OPERATOR(<, ToyLanes, ToyMask)
RASTERLAB_TOY_OPERATOR(<=, ToyLanes, ToyMask)
RASTERLAB_TOY_OPERATOR(>, ToyLanes, ToyMask)
RASTERLAB_TOY_OPERATOR(>=, ToyLanes, ToyMask)
RASTERLAB_TOY_OPERATOR(==, ToyLanes, ToyMask)
RASTERLAB_TOY_OPERATOR(+, ToyWhole, ToyWhole)
RASTERLAB_TOY_OPERATOR(*, ToyWhole, ToyWhole)
RASTERLAB_TOY_OPERATOR(&&, ToyMask, ToyMask)
RASTERLAB_TOY_OPERATOR(||, ToyMask, ToyMask)
#undef RASTERLAB_TOY_OPERATOR

template <int Lanes>
ToyMask<Lanes> operator!(const ToyMask<Lanes>& a) {
  return per_lane<ToyMask<Lanes>, Lanes>([&](std::size_t i) { return !a.lane[i]; });
}
template <int Lanes>
ToyLanes<Lanes> operator-(const ToyLanes<Lanes>& a) {
  return per_lane<ToyLanes<Lanes>, Lanes>([&](std::size_t i) { return -a.lane[i]; });
}
template <int Lanes>
ToyLanes<Lanes>& operator+=(ToyLanes<Lanes>& a, const ToyLanes<Lanes>& b) {
  return a = a + b;
}
template <int Lanes>
ToyLanes<Lanes>& operator*=(ToyLanes<Lanes>& a, const ToyLanes<Lanes>& b) {
  return a = a * b;
}
template <int Lanes>
ToyLanes<Lanes>& operator/=(ToyLanes<Lanes>& a, const ToyLanes<Lanes>& b) {
  return a = a / b;
}

template <int Lanes>
ToyLanes<Lanes> select(const ToyMask<Lanes>& condition, const ToyLanes<Lanes>& if_true,
                       const ToyLanes<Lanes>& if_false) {
  return per_lane<ToyLanes<Lanes>, Lanes>(
      [&](std::size_t i) { return condition.lane[i] ? if_true.lane[i] : if_false.lane[i]; });
}
template <int Lanes>
bool any(const ToyMask<Lanes>& mask) {
  return std::ranges::any_of(mask.lane, [](bool lane) { return lane; });
}
template <int Lanes>
bool all(const ToyMask<Lanes>& mask) {
  return std::ranges::all_of(mask.lane, [](bool lane) { return lane; });
}

#define RASTERLAB_TOY_FUNCTION(name)                                \
  template <int Lanes>                                              \
  ToyLanes<Lanes> name(const ToyLanes<Lanes>& a) {                  \
    return per_lane<ToyLanes<Lanes>, Lanes>(                        \
        [&](std::size_t i) { return rasterlab::name(a.lane[i]); }); \
  }
#define RASTERLAB_TOY_FUNCTION_OF_TWO(name)                                    \
  template <int Lanes>                                                         \
  ToyLanes<Lanes> name(const ToyLanes<Lanes>& a, const ToyLanes<Lanes>& b) {   \
    return per_lane<ToyLanes<Lanes>, Lanes>(                                   \
        [&](std::size_t i) { return rasterlab::name(a.lane[i], b.lane[i]); }); \
  }
RASTERLAB_TOY_FUNCTION(square_root)
RASTERLAB_TOY_FUNCTION(round_down)
RASTERLAB_TOY_FUNCTION(magnitude)
RASTERLAB_TOY_FUNCTION(log_2)
RASTERLAB_TOY_FUNCTION_OF_TWO(minimum)
RASTERLAB_TOY_FUNCTION_OF_TWO(maximum)
RASTERLAB_TOY_FUNCTION_OF_TWO(power)
#undef RASTERLAB_TOY_FUNCTION
#undef RASTERLAB_TOY_FUNCTION_OF_TWO
template <int Lanes>
ToyLanes<Lanes> fused_multiply_add(const ToyLanes<Lanes>& a, const ToyLanes<Lanes>& b,
                                   const ToyLanes<Lanes>& c) {
  return per_lane<ToyLanes<Lanes>, Lanes>([&](std::size_t i) {
    return rasterlab::fused_multiply_add(a.lane[i], b.lane[i], c.lane[i]);
  });
}
template <int Lanes>
ToyLanes<Lanes> power(const ToyLanes<Lanes>& base, float exponent) {
  return power(base, ToyLanes<Lanes>(exponent));
}

template <class Element, int Lanes>
ToyLanes<Lanes> gather(const Element* array, const ToyLanes<Lanes>& index) {
  return per_lane<ToyLanes<Lanes>, Lanes>(
      [&](std::size_t i) { return rasterlab::gather(array, index.lane[i]); });
}
template <int Lanes>
ToyWhole<Lanes> to_whole(const ToyLanes<Lanes>& a) {
  return per_lane<ToyWhole<Lanes>, Lanes>(
      [&](std::size_t i) { return rasterlab::to_whole(a.lane[i]); });
}

/// How many texels were read through a toy number, all lanes together.
inline int toy_texel_reads = 0;

template <int Lanes>
Vector3<ToyLanes<Lanes>> gather_texel(const TexelAndAbove* texels, const ToyWhole<Lanes>& index) {
  Vector3<ToyLanes<Lanes>> result;
  for (std::size_t i = 0; i < Lanes; ++i) {
    const Eigen::Vector3f texel = rasterlab::gather_texel(texels, index.lane[i]);
    for (int channel = 0; channel < 3; ++channel) result[channel].lane[i] = texel[channel];
    ++toy_texel_reads;
  }
  return result;
}

}  // namespace rasterlab

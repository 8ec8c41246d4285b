// The engine's wide numbers: as many lanes as the instruction set this file is compiled for has.
//
// Included only by files that rasterlab_add_simd_sources() compiles once per instruction set, each
// time in a namespace of its own, RASTERLAB_SIMD (simd_scalar … simd_avx512). Every operation is a
// single correctly rounded one per lane, or built from such in one fixed order: no estimates, and
// products are fused with sums only by fused_multiply_add(). So every instruction set gives the
// same bytes.
#pragma once

#ifndef RASTERLAB_SIMD
#error "compile this file with rasterlab_add_simd_sources()"
#endif

#include "common/image/number.h"

#include <bit>
#include <cstring>
#include <type_traits>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

namespace rasterlab::RASTERLAB_SIMD {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int lanes = HWY_LANES(float);
inline constexpr bool one_lane = lanes == 1;

using FloatTag = hn::CappedTag<float, lanes>;
using IntTag = hn::CappedTag<std::int32_t, lanes>;
using UintTag = hn::CappedTag<std::uint32_t, lanes>;
/// Doubles come as two vectors of half the lanes, or one when there is a single lane.
inline constexpr int half_lanes = one_lane ? 1 : lanes / 2;
using DoubleTag = hn::CappedTag<double, half_lanes>;
using HalfFloatTag = hn::CappedTag<float, half_lanes>;
using HalfIntTag = hn::CappedTag<std::int32_t, half_lanes>;

// ---------------------------------------------------------------------------------------------
// One truth value per lane

struct Truth {
  hn::Mask<FloatTag> mask;

  friend Truth operator&&(Truth a, Truth b) { return {hn::And(a.mask, b.mask)}; }
  friend Truth operator||(Truth a, Truth b) { return {hn::Or(a.mask, b.mask)}; }
  friend Truth operator!(Truth a) { return {hn::Not(a.mask)}; }
};

/// Lane i as bit i.
inline std::uint32_t bits(Truth truth) {
#if HWY_TARGET == HWY_AVX3
  return truth.mask.raw;
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag(), truth.mask, bytes);
  std::uint32_t result = 0;
  std::memcpy(&result, bytes, 4);
  return result;
#endif
}
inline bool any(Truth truth) {
  return !hn::AllFalse(FloatTag(), truth.mask);
}
inline bool all(Truth truth) {
  return hn::AllTrue(FloatTag(), truth.mask);
}
/// Bit i as lane i.
inline Truth truth_of(std::uint32_t lane_bits) {
#if HWY_TARGET == HWY_AVX3
  return {{static_cast<__mmask16>(lane_bits)}};
#else
  std::uint8_t bytes[8] = {};
  std::memcpy(bytes, &lane_bits, 4);
  return {hn::LoadMaskBits(FloatTag(), bytes)};
#endif
}
/// The first `count` lanes.
inline Truth first_lanes(int count) {
  return {hn::FirstN(FloatTag(), static_cast<std::size_t>(count))};
}

/// The same in all lanes.
inline Truth truth_if(bool condition) {
  return first_lanes(condition ? lanes : 0);
}

// ---------------------------------------------------------------------------------------------
// Integers of 32 bit, wrapping

struct Ints {
  hn::Vec<IntTag> v;

  Ints() = default;
  Ints(std::int32_t value) : v(hn::Set(IntTag(), value)) {}
  explicit Ints(hn::Vec<IntTag> value) : v(value) {}

  friend Ints operator+(Ints a, Ints b) { return Ints(hn::Add(a.v, b.v)); }
  friend Ints operator-(Ints a, Ints b) { return Ints(hn::Sub(a.v, b.v)); }
  friend Ints operator*(Ints a, Ints b) { return Ints(hn::Mul(a.v, b.v)); }
  friend Ints operator&(Ints a, Ints b) { return Ints(hn::And(a.v, b.v)); }
  friend Ints operator|(Ints a, Ints b) { return Ints(hn::Or(a.v, b.v)); }
  friend Truth operator<(Ints a, Ints b) { return {hn::RebindMask(FloatTag(), hn::Lt(a.v, b.v))}; }
  friend Truth operator>(Ints a, Ints b) { return {hn::RebindMask(FloatTag(), hn::Gt(a.v, b.v))}; }
  friend Truth operator<=(Ints a, Ints b) { return !(a > b); }
  friend Truth operator>=(Ints a, Ints b) { return !(a < b); }
  friend Truth operator==(Ints a, Ints b) { return {hn::RebindMask(FloatTag(), hn::Eq(a.v, b.v))}; }
};

template <int count>
Ints shift_left(Ints a) {
  return Ints(hn::ShiftLeft<count>(a.v));
}
/// Rounds down, as division by 2^count that keeps the sign.
template <int count>
Ints shift_right(Ints a) {
  return Ints(hn::ShiftRight<count>(a.v));
}
/// As unsigned ones.
template <int count>
Ints shift_right_unsigned(Ints a) {
  return Ints(hn::BitCast(IntTag(), hn::ShiftRight<count>(hn::BitCast(UintTag(), a.v))));
}
inline Ints minimum(Ints a, Ints b) {
  return Ints(hn::Min(a.v, b.v));
}
inline Ints maximum(Ints a, Ints b) {
  return Ints(hn::Max(a.v, b.v));
}
inline Ints select(Truth condition, Ints if_true, Ints if_false) {
  return Ints(hn::IfThenElse(hn::RebindMask(IntTag(), condition.mask), if_true.v, if_false.v));
}
alignas(64) inline constexpr std::array<std::int32_t, 16> lane_numbers = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// first, first + 1, …. Not Highway's, which writes them one by one to load them as a whole: a
/// processor stalls on that.
inline Ints iota(std::int32_t first) {
  return Ints(hn::Load(IntTag(), lane_numbers.data())) + Ints(first);
}
inline Ints load(const std::int32_t* from) {
  return Ints(hn::LoadU(IntTag(), from));
}
inline Ints load(const std::uint32_t* from) {
  return Ints(hn::BitCast(IntTag(), hn::LoadU(UintTag(), from)));
}
inline Ints load(const std::uint8_t* from) {
  return Ints(hn::PromoteTo(IntTag(), hn::LoadU(hn::CappedTag<std::uint8_t, lanes>(), from)));
}
inline void store(Ints a, std::int32_t* to) {
  hn::StoreU(a.v, IntTag(), to);
}
inline void store(Ints a, std::uint32_t* to) {
  hn::StoreU(hn::BitCast(UintTag(), a.v), UintTag(), to);
}
/// The chosen lanes side by side, as the first ones; what is written after them, up to a whole
/// vector, means nothing.
inline void store_packed(Truth chosen, Ints a, std::int32_t* to) {
  hn::StoreU(hn::Compress(a.v, hn::RebindMask(IntTag(), chosen.mask)), IntTag(), to);
}
/// The lanes' pairs of a lower and an upper half, side by side as words of 64 bits.
inline void store_words(Ints lower, Ints upper, std::int64_t* to) {
#if HWY_TARGET == HWY_SCALAR
  const std::array<std::int32_t, 2> halves = {hn::GetLane(lower.v), hn::GetLane(upper.v)};
  std::memcpy(to, halves.data(), sizeof halves);
#else
  hn::StoreInterleaved2(lower.v, upper.v, IntTag(), reinterpret_cast<std::int32_t*>(to));
#endif
}
inline void load_words(const std::int64_t* from, Ints& lower, Ints& upper) {
#if HWY_TARGET == HWY_SCALAR
  std::array<std::int32_t, 2> halves;
  std::memcpy(halves.data(), from, sizeof halves);
  lower = halves[0];
  upper = halves[1];
#else
  hn::LoadInterleaved2(IntTag(), reinterpret_cast<const std::int32_t*>(from), lower.v, upper.v);
#endif
}
inline Ints gather_ints(const std::int32_t* from, Ints index) {
  return Ints(hn::GatherIndex(IntTag(), from, index.v));
}
inline Ints gather_ints(const std::uint32_t* from, Ints index) {
  return Ints(hn::BitCast(IntTag(), hn::GatherIndex(UintTag(), from, index.v)));
}
inline std::int32_t smallest(Ints a) {
  return hn::GetLane(hn::MinOfLanes(IntTag(), a.v));
}
inline std::int32_t largest(Ints a) {
  return hn::GetLane(hn::MaxOfLanes(IntTag(), a.v));
}

// ---------------------------------------------------------------------------------------------
// Floats

struct Number {
  hn::Vec<FloatTag> v;

  Number() = default;
  Number(float value) : v(hn::Set(FloatTag(), value)) {}
  explicit Number(hn::Vec<FloatTag> value) : v(value) {}

  friend Number operator+(Number a, Number b) { return Number(hn::Add(a.v, b.v)); }
  friend Number operator-(Number a, Number b) { return Number(hn::Sub(a.v, b.v)); }
  friend Number operator*(Number a, Number b) { return Number(hn::Mul(a.v, b.v)); }
  friend Number operator/(Number a, Number b) { return Number(hn::Div(a.v, b.v)); }
  friend Number operator-(Number a) { return Number(hn::Neg(a.v)); }
  Number& operator+=(Number b) { return *this = *this + b; }
  Number& operator-=(Number b) { return *this = *this - b; }
  Number& operator*=(Number b) { return *this = *this * b; }
  Number& operator/=(Number b) { return *this = *this / b; }
  friend Truth operator<(Number a, Number b) { return {hn::Lt(a.v, b.v)}; }
  friend Truth operator<=(Number a, Number b) { return {hn::Le(a.v, b.v)}; }
  friend Truth operator>(Number a, Number b) { return {hn::Gt(a.v, b.v)}; }
  friend Truth operator>=(Number a, Number b) { return {hn::Ge(a.v, b.v)}; }
  friend Truth operator==(Number a, Number b) { return {hn::Eq(a.v, b.v)}; }
  friend Truth operator!=(Number a, Number b) { return !(a == b); }
};

}  // namespace rasterlab::RASTERLAB_SIMD

namespace Eigen {
template <>
struct NumTraits<rasterlab::RASTERLAB_SIMD::Number> : GenericNumTraits<float> {
  using Real = rasterlab::RASTERLAB_SIMD::Number;
  using NonInteger = rasterlab::RASTERLAB_SIMD::Number;
  using Nested = rasterlab::RASTERLAB_SIMD::Number;
  using Literal = float;
  enum { RequireInitialization = 0, IsComplex = 0, IsInteger = 0, IsSigned = 1 };
};
/// A vector of Numbers may be scaled by a plain float.
template <class Operation>
struct ScalarBinaryOpTraits<rasterlab::RASTERLAB_SIMD::Number, float, Operation> {
  using ReturnType = rasterlab::RASTERLAB_SIMD::Number;
};
template <class Operation>
struct ScalarBinaryOpTraits<float, rasterlab::RASTERLAB_SIMD::Number, Operation> {
  using ReturnType = rasterlab::RASTERLAB_SIMD::Number;
};
namespace internal {
/// As aligned as the Numbers themselves, which Eigen's own limit of 16 bytes would contradict.
template <int Size>
struct compute_default_alignment<rasterlab::RASTERLAB_SIMD::Number, Size> {
  enum { value = 0 };
};
}  // namespace internal
}  // namespace Eigen

namespace rasterlab::RASTERLAB_SIMD {

inline Number load(const float* from) {
  return Number(hn::LoadU(FloatTag(), from));
}
inline void store(Number a, float* to) {
  hn::StoreU(a.v, FloatTag(), to);
}
/// To aligned memory that nobody reads soon: past the caches, and without fetching it first. Others
/// see it after finish_streaming().
inline void stream(Number a, float* to) {
  hn::Stream(a.v, FloatTag(), to);
}
inline void finish_streaming() {
  hwy::FlushStream();
}
inline Number select(Truth condition, Number if_true, Number if_false) {
  return Number(hn::IfThenElse(condition.mask, if_true.v, if_false.v));
}
inline Truth select(Truth condition, Truth if_true, Truth if_false) {
  return (condition && if_true) || (!condition && if_false);
}
/// The smaller and the larger; when either is NaN, or both are zeros, b: as x86's instructions do
/// it.
inline Number minimum(Number a, Number b) {
  return one_lane ? select(a < b, a, b) : Number(hn::Min(a.v, b.v));
}
inline Number maximum(Number a, Number b) {
  return one_lane ? select(a > b, a, b) : Number(hn::Max(a.v, b.v));
}
inline Number square_root(Number a) {
  return Number(hn::Sqrt(a.v));
}
inline Number magnitude(Number a) {
  return Number(hn::Abs(a.v));
}
inline Number as_numbers(Ints a) {
  return Number(hn::ConvertTo(FloatTag(), a.v));
}
/// Toward zero. Of what doesn't fit, and of NaN, no one may ask: Highway's own conversion takes
/// four instructions more to give those a meaning.
inline Ints to_whole(Number a) {
#if HWY_TARGET == HWY_AVX3
  return Ints(hn::Vec<IntTag>{_mm512_maskz_cvttps_epi32(0xFFFF, a.v.raw)});
#elif HWY_TARGET == HWY_AVX2
  return Ints(hn::Vec<IntTag>{_mm256_cvttps_epi32(a.v.raw)});
#else
  return Ints(hn::ConvertTo(IntTag(), a.v));
#endif
}
/// To nearest, ties to even; likewise.
inline Ints round_to_ints(Number a) {
#if HWY_TARGET == HWY_AVX3
  return Ints(hn::Vec<IntTag>{_mm512_maskz_cvtps_epi32(0xFFFF, a.v.raw)});
#elif HWY_TARGET == HWY_AVX2
  return Ints(hn::Vec<IntTag>{_mm256_cvtps_epi32(a.v.raw)});
#else
  // Not beyond the last float below 2^31: Highway's one lane converts 2^31 itself, undefined in
  // C++.
  return Ints(hn::NearestInt(hn::Min(a.v, hn::Set(FloatTag(), 0x1.fffffep30F))));
#endif
}
inline Ints bit_pattern(Number a) {
  return Ints(hn::BitCast(IntTag(), a.v));
}
inline Number from_bit_pattern(Ints a) {
  return Number(hn::BitCast(FloatTag(), a.v));
}
inline Number round_down(Number a) {
#if HWY_TARGET == HWY_SSSE3  // which has no such instruction, and whose stand-in loses −0
  return Number(hn::CopySign(hn::Floor(a.v), a.v));
#else
  return Number(hn::Floor(a.v));
#endif
}
inline float smallest(Number a) {
  return hn::GetLane(hn::MinOfLanes(FloatTag(), a.v));
}
inline float largest(Number a) {
  return hn::GetLane(hn::MaxOfLanes(FloatTag(), a.v));
}
inline Number gather_numbers(const float* from, Ints index) {
  return Number(hn::GatherIndex(FloatTag(), from, index.v));
}

inline Number gather(const float* array, Number index) {
  return gather_numbers(array, to_whole(index));
}
/// A table that fits a register or two needs no memory.
inline Number look_up(const std::array<float, 16>& table, Ints index) {
  if constexpr (lanes == 16) {
    const auto at = hn::IndicesFromVec(FloatTag(), index.v);
    return Number(hn::TableLookupLanes(load(table.data()).v, at));
  } else {
    return gather_numbers(table.data(), index);
  }
}
inline Number gather(const std::array<float, 16>& table, Number index) {
  return look_up(table, to_whole(index));
}
inline Number gather(const std::uint8_t* array, Number index) {
  alignas(64) std::int32_t at[lanes];
  alignas(64) float element[lanes];
  store(to_whole(index), at);
  for (int lane = 0; lane < lanes; ++lane) element[lane] = static_cast<float>(array[at[lane]]);
  return load(element);
}

#if HWY_TARGET == HWY_SCALAR
/// Four consecutive numbers of a place per lane, `place(lane)`, where there may be something else
/// than floats.
template <class Place>
void load_fours(const Place& place, Number* fours) {
  float values[4];
  std::memcpy(values, place(0), sizeof values);
  for (int i = 0; i < 4; ++i) fours[i] = Number(values[i]);
}
/// To places of the first `count` lanes.
inline void store_fours(const Number* fours, float* const* to, int count) {
  for (int i = 0; i < 4 * count; ++i) to[0][i] = hn::GetLane(fours[i].v);
}
#else
/// The four numbers of places first, first + 4, first + 8, …, side by side.
template <int count, class Place>
hn::Vec<hn::CappedTag<float, count>> load_every_fourth(const Place& place, std::size_t first) {
  const hn::CappedTag<float, count> tag;
  if constexpr (count == 4) {
    return hn::LoadU(tag, place(first));
  } else {
    return hn::Combine(tag, load_every_fourth<count / 2>(place, first + count / 2),
                       load_every_fourth<count / 2>(place, first));
  }
}
/// In each group of four lanes, number i of lane j to number j of lane i.
inline void transpose_fours(Number* fours) {
  const FloatTag tag;
  const hn::RepartitionToWide<FloatTag> pairs;
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(tag, fours[0].v, fours[1].v));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(tag, fours[2].v, fours[3].v));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(tag, fours[0].v, fours[1].v));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(tag, fours[2].v, fours[3].v));
  fours[0] = Number(hn::BitCast(tag, hn::InterleaveLower(pairs, low01, low23)));
  fours[1] = Number(hn::BitCast(tag, hn::InterleaveUpper(pairs, low01, low23)));
  fours[2] = Number(hn::BitCast(tag, hn::InterleaveLower(pairs, high01, high23)));
  fours[3] = Number(hn::BitCast(tag, hn::InterleaveUpper(pairs, high01, high23)));
}
/// Four consecutive numbers of a place per lane, `place(lane)`: cheaper than four gathers.
template <class Place>
void load_fours(const Place& place, Number* fours) {
  for (std::size_t i = 0; i < 4; ++i) fours[i] = Number(load_every_fourth<lanes>(place, i));
  transpose_fours(fours);
}
/// To places of the first `count` lanes.
inline void store_fours(const Number* fours, float* const* to, int count) {
  std::array<Number, 4> rows = {fours[0], fours[1], fours[2], fours[3]};
  transpose_fours(rows.data());
  alignas(64) std::array<std::array<float, lanes>, 4> row;
  for (std::size_t i = 0; i < 4; ++i) store(rows[i], row[i].data());
  for (int lane = 0; lane < count; ++lane) {
    std::memcpy(to[lane], row[static_cast<std::size_t>(lane % 4)].data() + lane / 4 * 4, 16);
  }
}
#endif

/// Per lane its byte `from` at place `to`, and else zeros.
template <int from, int to>
Ints moved_byte(Ints a) {
#if HWY_TARGET == HWY_SCALAR
  return shift_left<8 * to>(shift_right<8 * from>(a) & Ints(255));
#else
  // By permutation: shifts would begin in the same pipes as sums and conversions to float.
  alignas(64) static constexpr std::array<std::uint32_t, 16> places = [] {
    std::array<std::uint32_t, 16> place{};
    for (std::uint32_t i = 0; i < 16; ++i) {
      place[i] = (0x80808080U & ~(0xFFU << 8 * to)) | (i % 4 * 4 + from) << 8 * to;
    }
    return place;
  }();
  const hn::Repartition<std::uint8_t, IntTag> bytes;
  const auto place = hn::BitCast(bytes, hn::Load(UintTag(), places.data()));
  return Ints(hn::BitCast(IntTag(), hn::TableLookupBytesOr0(hn::BitCast(bytes, a.v), place)));
#endif
}
inline Vector3<Number> unpack_texel(Ints texel) {
  return {as_numbers(texel & Ints(255)), as_numbers(moved_byte<1, 0>(texel)),
          as_numbers(moved_byte<2, 0>(texel))};
}

/// Has what nobody reads computed all the same.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "m"(value));  // NOLINT(hicpp-no-assembler)
}

/// Per lane a number for addresses, read from memory: left to itself, the compiler takes the lanes
/// out of the register one by one, by three operations each that vectors wait for.
struct Addresses {
  alignas(64) std::array<std::int32_t, lanes> of_lane;

  explicit Addresses(Ints numbers) {
    store(numbers, of_lane.data());
    asm("" : "+m"(of_lane));  // NOLINT(hicpp-no-assembler)
  }
};

inline Vector3<Number> gather_texel(const TexelAndAbove* texels, Ints index) {
  const Addresses at(index);
  alignas(64) std::array<std::uint32_t, lanes> texel;
  for (std::size_t i = 0; i < lanes; ++i) texel[i] = texels[at.of_lane[i]].texel;
  return unpack_texel(load(texel.data()));
}

/// Per lane the texel, the next one, and the two above them: a load a lane and a transposition in
/// place of four gathers.
inline std::array<Vector3<Number>, 4> gather_square(const TexelAndAbove* texels, Ints index) {
  const Addresses at(index);
  std::array<Number, 4> fours;
  load_fours([&](std::size_t i) { return reinterpret_cast<const float*>(texels + at.of_lane[i]); },
             fours.data());
  return {unpack_texel(bit_pattern(fours[0])), unpack_texel(bit_pattern(fours[2])),
          unpack_texel(bit_pattern(fours[1])), unpack_texel(bit_pattern(fours[3]))};
}

#if HWY_TARGET == HWY_AVX3
// The same for lanes whose texels lie close together, as they do where a texture is magnified: all
// of them are in 8 columns and 4 rows, which are loaded and unpacked once; each lane then finds its
// own by permutation.

/// A lane in the midst of the others, and where its square is.
struct MiddleLane {
  float left, low;

  MiddleLane(Number left_of_lanes, Number low_of_lanes)
      : left(of_lanes(left_of_lanes)), low(of_lanes(low_of_lanes)) {}

  static float of_lanes(Number a) { return hn::GetLane(hn::Broadcast<3>(a.v)); }

  /// Whether the columns and rows around it are part of the picture.
  bool is_inside(int width, int height) const {
    return left >= 3 && left < static_cast<float>(width - 4) && low >= 1 &&
           low < static_cast<float>(height - 2);
  }
  /// The first of their texels. Asked where they are inside.
  std::ptrdiff_t corner(int width) const {
    return static_cast<std::ptrdiff_t>(static_cast<int>(low) - 1) * width +
           (static_cast<int>(left) - 3);
  }
};

/// Where the lanes' squares are from there.
struct FromMiddle {
  Number right, up;

  FromMiddle(MiddleLane middle, Number left, Number low)
      : right(left - Number(middle.left)), up(low - Number(middle.low)) {}

  bool are_near() const { return all(magnitude(right) <= Number(3) && magnitude(up) <= Number(1)); }
  /// Which of the texels is each square's first.
  Ints first() const { return to_whole(right + up * Number(8)) + Ints(3 + 8); }
};

struct NearSquares {
  bool found;
  std::ptrdiff_t corner;
  Ints first;
};

inline NearSquares find_near_squares(int width, int height, Number left, Number low) {
  const MiddleLane middle(left, low);
  const FromMiddle squares(middle, left, low);
  if (!middle.is_inside(width, height) || !squares.are_near()) return {};
  return {true, middle.corner(width), squares.first()};
}

/// The columns and rows, unpacked.
struct NearTexels {
  Vector3<Number> lower;  ///< two rows of eight
  Vector3<Number> upper;  ///< the next two

  NearTexels(const TexelAndAbove* corner, int width) {
    const auto row_and_above = [&](const TexelAndAbove* row) {
      alignas(64) static constexpr std::array<std::int32_t, 16> rows_apart = {
          0, 2, 4, 6, 8, 10, 12, 14, 1, 3, 5, 7, 9, 11, 13, 15};
      const auto order = hn::IndicesFromVec(IntTag(), load(rows_apart.data()).v);
      return unpack_texel(
          Ints(hn::TableLookupLanes(load(reinterpret_cast<const std::uint32_t*>(row)).v, order)));
    };
    lower = row_and_above(corner);
    upper = row_and_above(corner + std::ptrdiff_t{2} * width);
  }

  /// Per lane.
  Vector3<Number> texel(Ints at) const {
    const auto channel = [&](int i) {
      return Number(
          hn::Vec<FloatTag>{_mm512_permutex2var_ps(lower[i].v.raw, at.v.raw, upper[i].v.raw)});
    };
    return {channel(0), channel(1), channel(2)};
  }
  std::array<Vector3<Number>, 4> squares(Ints first) const {
    return {texel(first), texel(first + Ints(1)), texel(first + Ints(8)), texel(first + Ints(9))};
  }
};

inline std::array<Vector3<Number>, 4> gather_near_squares(const TexelAndAbove* texels, int width,
                                                          const NearSquares& squares) {
  return NearTexels(texels + squares.corner, width).squares(squares.first);
}
#endif

// ---------------------------------------------------------------------------------------------
// Doubles, for what must be exact beyond 24 bits

struct Doubles {
  hn::Vec<DoubleTag> low;
  hn::Vec<DoubleTag> high;  // unused with a single lane

  Doubles() = default;
  Doubles(double value) : low(hn::Set(DoubleTag(), value)), high(low) {}
  Doubles(hn::Vec<DoubleTag> l, hn::Vec<DoubleTag> h) : low(l), high(h) {}

  friend Doubles operator+(Doubles a, Doubles b) {
    return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
  }
  friend Doubles operator-(Doubles a, Doubles b) {
    return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
  }
  friend Doubles operator*(Doubles a, Doubles b) {
    return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
  }
  friend Doubles operator/(Doubles a, Doubles b) {
    return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
  }
};

/// Rounded to nearest.
inline Number to_number(Doubles a) {
  const HalfFloatTag half;
#if HWY_TARGET == HWY_SCALAR
  return Number(hn::DemoteTo(half, a.low));
#else
  return Number(hn::Combine(FloatTag(), hn::DemoteTo(half, a.high), hn::DemoteTo(half, a.low)));
#endif
}
inline Doubles to_doubles(Ints a) {
#if HWY_TARGET == HWY_SCALAR
  const auto wide = hn::PromoteTo(DoubleTag(), a.v);
  return {wide, wide};
#else
  const HalfIntTag half;
  return {hn::PromoteTo(DoubleTag(), hn::LowerHalf(half, a.v)),
          hn::PromoteTo(DoubleTag(), hn::UpperHalf(half, a.v))};
#endif
}
inline Doubles to_doubles(Doubles a) {
  return a;
}
inline Doubles to_doubles(Number a) {
#if HWY_TARGET == HWY_SCALAR
  const auto wide = hn::PromoteTo(DoubleTag(), a.v);
  return {wide, wide};
#else
  const HalfFloatTag half;
  return {hn::PromoteTo(DoubleTag(), hn::LowerHalf(half, a.v)),
          hn::PromoteTo(DoubleTag(), hn::UpperHalf(half, a.v))};
#endif
}

// a · b + c, rounded once: fused_multiply_add().
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
inline Number fused_multiply_add(Number a, Number b, Number c) {
  return Number(hn::MulAdd(a.v, b.v, c.v));
}
#elif HWY_TARGET == HWY_SCALAR
inline Number fused_multiply_add(Number a, Number b, Number c) {
  return Number(std::fma(hn::GetLane(a.v), hn::GetLane(b.v), hn::GetLane(c.v)));
}
#else
/// The sum, whose last bit is set where it isn't exact: rounded to fewer bits, it becomes what the
/// exact sum would. Of numbers whose sum is far from overflow, or that aren't numbers.
inline hn::Vec<DoubleTag> sum_rounded_to_odd(hn::Vec<DoubleTag> a, hn::Vec<DoubleTag> b) {
  const hn::Rebind<std::int64_t, DoubleTag> whole;
  const auto sum = hn::Add(a, b);
  const auto from_b = hn::Sub(sum, a);
  const auto lost = hn::Add(hn::Sub(a, hn::Sub(sum, from_b)), hn::Sub(b, from_b));
  const auto zero = hn::Zero(DoubleTag());
  const auto is_inexact = hn::Or(hn::Lt(lost, zero), hn::Gt(lost, zero));
  // One less where the rounding went away from zero.
  const auto pattern = hn::BitCast(whole, sum);
  const auto too_far = hn::BroadcastSignBit(hn::Xor(pattern, hn::BitCast(whole, lost)));
  const auto odd = hn::Or(hn::Add(pattern, too_far), hn::Set(whole, 1));
  return hn::IfThenElse(is_inexact, hn::BitCast(DoubleTag(), odd), sum);
}
/// By doubles, which hold a product of floats exactly. A call each: shaders would take many times
/// as long to compile.
[[gnu::noinline]] inline Number fused_multiply_add(Number a, Number b, Number c) {
  const Doubles product = to_doubles(a) * to_doubles(b);
  const Doubles addend = to_doubles(c);
  return to_number(Doubles(sum_rounded_to_odd(product.low, addend.low),
                           sum_rounded_to_odd(product.high, addend.high)));
}
#endif

inline Doubles load(const double* from) {
  return {hn::LoadU(DoubleTag(), from), hn::LoadU(DoubleTag(), from + (one_lane ? 0 : half_lanes))};
}
inline void store(Doubles a, double* to) {
  hn::StoreU(a.low, DoubleTag(), to);
  if constexpr (!one_lane) hn::StoreU(a.high, DoubleTag(), to + half_lanes);
}

inline Doubles select(Truth condition, Doubles if_true, Doubles if_false) {
#if HWY_TARGET == HWY_AVX3
  const auto low = static_cast<__mmask8>(condition.mask.raw);
  const auto high = static_cast<__mmask8>(condition.mask.raw >> 8U);
  return {hn::IfThenElse({low}, if_true.low, if_false.low),
          hn::IfThenElse({high}, if_true.high, if_false.high)};
#elif HWY_TARGET == HWY_SCALAR
  return any(condition) ? if_true : if_false;
#else
  const hn::Rebind<std::int64_t, DoubleTag> wide;
  const HalfIntTag half;
  const auto lane = hn::VecFromMask(IntTag(), hn::RebindMask(IntTag(), condition.mask));
  const auto chosen = [&](auto of_half) {
    return hn::MaskFromVec(hn::BitCast(DoubleTag(), hn::PromoteTo(wide, of_half)));
  };
  return {hn::IfThenElse(chosen(hn::LowerHalf(half, lane)), if_true.low, if_false.low),
          hn::IfThenElse(chosen(hn::UpperHalf(half, lane)), if_true.high, if_false.high)};
#endif
}

inline Doubles gather_doubles(const double* from, Ints index) {
#if HWY_TARGET == HWY_SCALAR
  return Doubles(from[hn::GetLane(index.v)]);
#else
  const hn::CappedTag<std::int64_t, half_lanes> wide;
  const HalfIntTag half;
  return {hn::GatherIndex(DoubleTag(), from, hn::PromoteTo(wide, hn::LowerHalf(half, index.v))),
          hn::GatherIndex(DoubleTag(), from, hn::PromoteTo(wide, hn::UpperHalf(half, index.v)))};
#endif
}

// ---------------------------------------------------------------------------------------------
// Colours

/// [0, 1] to 0…255 as to_byte() does; not a number becomes 0.
inline Ints byte_of_color(Number value) {
  const Number inside = minimum(maximum(value, Number(0)), Number(1));
  return to_whole(inside * Number(255) + Number(0.5F));
}
/// Per lane as pack_texel() does.
inline Ints pack_color(Number red, Number green, Number blue) {
#if HWY_TARGET == HWY_AVX3
  // Below 0, and not numbers, become negative: packing bounds them. Numbers come second in
  // minimum(), which lets pass what isn't one.
  const auto whole = [](Number value) {
    return to_whole(minimum(Number(255.5F), value * Number(255) + Number(0.5F))).v.raw;
  };
  const __m512i words01 = _mm512_packs_epi32(whole(red), whole(green));
  const __m512i words2 = _mm512_packs_epi32(whole(blue), _mm512_setzero_si512());
  alignas(16) static constexpr std::array<std::uint8_t, 16> interleaved = {
      0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
  const hn::Repartition<std::uint8_t, IntTag> bytes;
  const auto order = hn::LoadDup128(bytes, interleaved.data());
  return Ints(hn::BitCast(
      IntTag(), hn::TableLookupBytes(
                    hn::VFromD<decltype(bytes)>{_mm512_packus_epi16(words01, words2)}, order)));
#else
  return byte_of_color(red) | moved_byte<0, 1>(byte_of_color(green)) |
         moved_byte<0, 2>(byte_of_color(blue));
#endif
}

// ---------------------------------------------------------------------------------------------
// Logarithm and power, the same bits everywhere

/// log2, for a ≥ 0; of 0, −126 or less. Error below 2e-7 + 1e-7 · |log2 a|: the exponent, plus a
/// polynomial in s = (m − 1) / (m + 1) for the mantissa m in [√½, √2) (the series of artanh).
inline Number log_2(Number a) {
  const Ints pattern = bit_pattern(maximum(a, Number(1.17549435e-38F)));
  const Ints shifted = pattern - Ints(0x3F3504F3);  // √½
  const Ints exponent = shift_right<23>(shifted);
  const Number mantissa = from_bit_pattern(pattern - shift_left<23>(exponent));
  const Number s = (mantissa - Number(1)) / (mantissa + Number(1));
  const Number t = s * s;
  Number series = t * Number(0.32059890F) + Number(0.41219858F);
  series = series * t + Number(0.57707802F);
  series = series * t + Number(0.96179669F);
  return as_numbers(exponent) + (s * Number(2.88539008F) + s * t * series);
}

/// 2^a, relative error below 3e-7; saturates beyond [−126, 128).
inline Number exp_2(Number a) {
  const Number inside = minimum(maximum(a, Number(-126)), Number(127.99999F));
  const Ints whole = round_to_ints(inside);
  const Number f = inside - as_numbers(whole);
  Number series = f * Number(1.54035304e-4F) + Number(1.33335581e-3F);
  series = series * f + Number(9.61812911e-3F);
  series = series * f + Number(5.55041087e-2F);
  series = series * f + Number(2.40226507e-1F);
  series = series * f + Number(6.93147181e-1F);
  series = series * f + Number(1);
  // In two steps, so that 2^128 needn't be representable.
  const Ints first = shift_right<1>(whole);
  const Ints second = whole - first;
  const auto scale = [](Ints e) { return from_bit_pattern(shift_left<23>(e + Ints(127))); };
  return series * scale(first) * scale(second);
}

/// 0^0 is 1, 0^exponent is 0.
inline Number power(Number base, Number exponent) {
  const Number result = exp_2(exponent * log_2(base));
  return select(base > Number(0), result, select(exponent == Number(0), Number(1), Number(0)));
}

/// The same exponent in all lanes; a whole one by squaring: closer, and a fifth of the operations.
template <class AnyNumber>
AnyNumber power_by_squaring(AnyNumber base, int exponent) {
  AnyNumber result(1);
  for (; exponent > 1; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base;
    base = base * base;
  }
  return exponent == 0 ? result : result * base;
}
inline bool is_small_and_whole(float exponent) {
  return exponent >= 0 && exponent <= 1024 &&
         static_cast<float>(static_cast<int>(exponent)) == exponent;
}
inline Number power(Number base, float exponent) {
  if (is_small_and_whole(exponent)) return power_by_squaring(base, static_cast<int>(exponent));
  return power(base, Number(exponent));
}

}  // namespace rasterlab::RASTERLAB_SIMD

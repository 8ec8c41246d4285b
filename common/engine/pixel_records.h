// The records of the triangles that a vector of pixels sees, word by word.
#pragma once

#include "common/engine/visible_triangles.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

/// All pixels see the same triangle.
class OneRecord {
 public:
  OneRecord(const VisibleTriangles& triangles, std::int32_t slot)
      : words_(triangles.record(slot)), front_(triangles.triangle(slot).front) {}

  Ints integer(int i) const { return Ints(std::bit_cast<std::int32_t>(words_[i])); }
  Number number(int i) const { return Number(words_[i]); }
  Doubles integer_as_doubles(int i) const {
    return Doubles(static_cast<double>(std::bit_cast<std::int32_t>(words_[i])));
  }
  Doubles number_as_doubles(int i) const { return Doubles(static_cast<double>(words_[i])); }
  Truth front_facing() const { return Ints(front_ ? 1 : 0) == Ints(1); }

 private:
  const float* words_;
  bool front_;
};

/// They see different ones: lane i of a word is pixel i's. Lanes that see none have the first
/// one's.
template <int word_count>
class EachRecordOf {
 public:
  [[gnu::noinline]] EachRecordOf(const VisibleTriangles& triangles, const PartsOfVector& seen) {
    if (one_lane || seen.count <= most_merged) {
      merge(triangles, seen.parts());
    } else {
      transpose(triangles, seen.parts());
    }
    for (const PartOfVector& part : seen.parts()) {
      if (triangles.triangle(part.slot).front) front_ |= part.lanes;
    }
  }

  Ints integer(int i) const { return bit_pattern(words_[static_cast<std::size_t>(i)]); }
  Number number(int i) const { return words_[static_cast<std::size_t>(i)]; }
  Doubles integer_as_doubles(int i) const { return to_doubles(integer(i)); }
  Doubles number_as_doubles(int i) const { return to_doubles(number(i)); }
  Truth front_facing() const { return truth_of(front_); }

 private:
  /// Up to this many, an instruction for each word of each is less than a transposition.
  static constexpr int most_merged = 6;

  void merge(const VisibleTriangles& triangles, std::span<const PartOfVector> parts) {
    const float* first = triangles.record(parts[0].slot);
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] = Number(first[w]);
    if constexpr (one_lane) return;
    for (const PartOfVector& part : parts.subspan(1)) {
      const float* record = triangles.record(part.slot);
      const Truth here = truth_of(part.lanes);
      for (std::size_t w = 0; w < words_.size(); ++w) {
        words_[w] = select(here, Number(record[w]), words_[w]);
      }
    }
  }

  void transpose(const VisibleTriangles& triangles, std::span<const PartOfVector> parts) {
    std::array<const float*, lanes> record;
    record.fill(triangles.record(parts[0].slot));
    for (const PartOfVector& part : parts.subspan(1)) {
      for (std::uint32_t rest = part.lanes; rest != 0; rest &= rest - 1) {
        record[static_cast<std::size_t>(std::countr_zero(rest))] = triangles.record(part.slot);
      }
    }
    for (std::size_t w = 0; w < words_.size(); w += 4) {
      load_fours(record.data(), &words_[w]);
      for (const float*& from : record) from += 4;
    }
  }

  std::array<Number, static_cast<std::size_t>(word_count)> words_;
  std::uint32_t front_ = 0;
};

}  // namespace rasterlab::RASTERLAB_SIMD

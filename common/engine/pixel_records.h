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
  Doubles number_as_doubles(int i) const { return Doubles(static_cast<double>(words_[i])); }
  Truth front_facing() const { return Ints(front_ ? 1 : 0) == Ints(1); }

 private:
  const float* words_;
  bool front_;
};

/// The records of a few triangles, word by word.
template <int word_count>
struct RecordTable {
  static constexpr std::size_t most = 16;

  alignas(64) std::array<std::array<float, most>, static_cast<std::size_t>(word_count)> word;

  [[gnu::noinline]] void fill(const VisibleTriangles& triangles,
                              std::span<const VisiblePart> parts) {
    for (std::size_t first = 0; first < parts.size(); first += lanes) {
      std::array<const float*, lanes> record;
      for (std::size_t i = 0; i < lanes; ++i) {
        record[i] = triangles.record(parts[std::min(first + i, parts.size() - 1)].slot);
      }
      for (std::size_t w = 0; w < word.size(); w += 4) {
        std::array<Number, 4> fours;
        load_fours([&](std::size_t lane) { return record[lane] + w; }, fours.data());
        for (std::size_t j = 0; j < 4; ++j) store(fours[j], word[w + j].data() + first);
      }
    }
  }
};

/// Pixels see different ones, each the one of its number in a table.
template <int word_count>
class EachRecord {
 public:
  EachRecord(const RecordTable<word_count>& table, Ints number_in_table, std::uint32_t front)
      : table_(table), number_in_table_(number_in_table), front_(front) {}

  Ints integer(int i) const { return bit_pattern(number(i)); }
  Number number(int i) const {
    return look_up(table_.word[static_cast<std::size_t>(i)], number_in_table_);
  }
  Doubles integer_as_doubles(int i) const { return to_doubles(integer(i)); }
  Doubles number_as_doubles(int i) const { return to_doubles(number(i)); }
  Truth front_facing() const { return truth_of(front_); }

 private:
  const RecordTable<word_count>& table_;
  Ints number_in_table_;
  std::uint32_t front_;
};

}  // namespace rasterlab::RASTERLAB_SIMD

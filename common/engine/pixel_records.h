// The records of the triangles that a vector of pixels sees, word by word.
#pragma once

#include "common/engine/visible_triangles.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

/// All pixels see the same triangle.
class OneRecord {
 public:
  OneRecord() = default;
  OneRecord(const VisibleTriangles& triangles, std::int32_t slot)
      : words_(triangles.record(slot)), front_(triangles.triangle(slot).front) {}

  Ints integer(int i) const { return Ints(std::bit_cast<std::int32_t>(words_[i])); }
  Number number(int i) const { return Number(words_[i]); }
  Truth front_facing() const { return Ints(front_ ? 1 : 0) == Ints(1); }

 private:
  const float* words_ = nullptr;
  bool front_ = false;
};

/// Pixels see one of two triangles.
class OneOfTwoRecords {
 public:
  OneOfTwoRecords(const OneRecord& first, const OneRecord& second, Truth is_second)
      : first_(first), second_(second), is_second_(is_second) {}

  Ints integer(int i) const { return select(is_second_, second_.integer(i), first_.integer(i)); }
  Number number(int i) const { return select(is_second_, second_.number(i), first_.number(i)); }
  Truth front_facing() const {
    return select(is_second_, second_.front_facing(), first_.front_facing());
  }

 private:
  OneRecord first_;
  OneRecord second_;
  Truth is_second_;
};

/// Which of some records each pixel of a block sees.
struct RecordNumbers {
  alignas(64) std::array<std::int32_t, 64> number;
  BlockMask front = 0;
};

/// The records of a few triangles, word by word.
template <int word_count>
struct RecordTable {
  static constexpr std::size_t most = 16;

  alignas(64) std::array<std::array<float, most>, static_cast<std::size_t>(word_count)> word;

  [[gnu::noinline, gnu::flatten]] void fill(const VisibleTriangles& triangles,
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
class EachRecord {
 public:
  using Word = std::array<float, 16>;

  /// Of the pixels from `first` on.
  EachRecord(const Word* words, const RecordNumbers& numbers, int first)
      : words_(words),
        number_in_table_(load(&numbers.number[static_cast<std::size_t>(first)])),
        front_(lanes_at(numbers.front, first)) {}

  Ints integer(int i) const { return bit_pattern(number(i)); }
  Number number(int i) const { return look_up(words_[i], number_in_table_); }
  Truth front_facing() const { return truth_of(front_); }

 private:
  const Word* words_;
  Ints number_in_table_;
  std::uint32_t front_;
};

/// Pixels see any triangles at all: `word_count` words of each one's record.
template <int word_count>
class OwnRecords {
 public:
  /// `slot`: of each lane.
  OwnRecords(const VisibleTriangles& triangles, const std::int32_t* slot)
      : triangles_(triangles), slot_(slot) {
    for (std::size_t w = 0; w < word_.size(); w += 4) {
      load_fours([&](std::size_t lane) { return triangles.record(slot[lane]) + w; }, &word_[w]);
    }
  }

  Ints integer(int i) const { return bit_pattern(number(i)); }
  Number number(int i) const { return word_[static_cast<std::size_t>(i)]; }
  Truth front_facing() const {
    std::uint32_t front = 0;
    for (int lane = 0; lane < lanes; ++lane) {
      front |= std::uint32_t{triangles_.triangle(slot_[lane]).front} << lane;
    }
    return truth_of(front);
  }

 private:
  const VisibleTriangles& triangles_;
  const std::int32_t* slot_;
  std::array<Number, (word_count + 3) / 4 * 4> word_;
};

/// Edge function 1 or 2 of a large triangle whose record `words` is, at a pixel of the picture.
inline double large_edge(const ShadedTriangle& triangle, const float* words, int edge, int x,
                         int y) {
  const auto step = [&](int of_1, int of_2) {
    return static_cast<double>(std::bit_cast<std::int32_t>(words[edge == 1 ? of_1 : of_2]));
  };
  return triangle.edges[static_cast<std::size_t>(edge - 1)] +
         256.0 * (step(word::step1_x, word::step2_x) * x + step(word::step1_y, word::step2_y) * y);
}

/// Edge functions at pixels of the picture, each in the triangle it sees; of large ones anything.
template <class Record>
Edges edges_at(const Record& r, Ints x, Ints y) {
  const auto edge = [&](int at_first, int step_x, int step_y) {
    return to_doubles(r.integer(at_first) +
                      shift_left<8>(x * r.integer(step_x) + y * r.integer(step_y)));
  };
  const Doubles e1 = edge(word::edge1, word::step1_x, word::step1_y);
  const Doubles e2 = edge(word::edge2, word::step2_x, word::step2_y);
  return {to_doubles(r.integer(word::area)) - (e1 + e2), e1, e2};
}

}  // namespace rasterlab::RASTERLAB_SIMD

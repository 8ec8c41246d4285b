// Random numbers that are the same on every platform.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace rasterlab::stress {

class Random {
 public:
  explicit Random(std::initializer_list<std::uint64_t> seed) {
    std::vector<std::uint32_t> words;
    for (const std::uint64_t part : seed) {
      words.push_back(static_cast<std::uint32_t>(part));
      words.push_back(static_cast<std::uint32_t>(part >> 32U));
    }
    std::seed_seq sequence(words.begin(), words.end());
    generator_.seed(sequence);
  }

  /// In [low, high).
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11U) * 0x1p-53;
  }

  /// One of low, low + 1, …, high.
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return low +
           static_cast<std::int64_t>(generator_() % static_cast<std::uint64_t>(high - low + 1));
  }

  bool chance(double part) { return number(0, 1) < part; }

  double pick(std::initializer_list<double> numbers) {
    return numbers.begin()[whole(0, static_cast<std::int64_t>(numbers.size()) - 1)];
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace rasterlab::stress

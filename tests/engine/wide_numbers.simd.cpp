#include "tests/engine/wide_numbers.h"

#include "common/engine/simd.h"

#include <array>

namespace rasterlab::RASTERLAB_SIMD {

namespace {

/// Calls `compute(a, b, c)` for a vector of operands after the other and stores what it gives.
template <class Result, class Compute>
void for_each_vector(std::span<const ThreeNumbers> operands, Result* results,
                     const Compute& compute) {
  for (std::size_t first = 0; first < operands.size(); first += lanes) {
    const auto some =
        operands.subspan(first, std::min<std::size_t>(lanes, operands.size() - first));
    std::array<float, lanes> a{};
    std::array<float, lanes> b{};
    std::array<float, lanes> c{};
    for (std::size_t i = 0; i < some.size(); ++i) {
      a[i] = some[i].a;
      b[i] = some[i].b;
      c[i] = some[i].c;
    }
    std::array<Result, lanes> result;
    store(compute(load(a.data()), load(b.data()), load(c.data())), result.data());
    std::copy_n(result.begin(), some.size(), results + first);
  }
}

void fuse(std::span<const ThreeNumbers> operands, float* results) {
  for_each_vector(operands, results,
                  [](Number a, Number b, Number c) { return fused_multiply_add(a, b, c); });
}

void pack(std::span<const ThreeNumbers> colors, std::uint32_t* results) {
  for_each_vector(colors, results,
                  [](Number r, Number g, Number b) { return pack_color(r, g, b); });
}

}  // namespace

WideNumbers wide_numbers() {
  return {&fuse, &pack};
}

}  // namespace rasterlab::RASTERLAB_SIMD

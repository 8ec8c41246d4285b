// Points of surfaces as arrays, and shading them by SIMD vectors, compiled once per instruction
// set.
#pragma once

#include "common/engine/compiled_simd_targets.h"

#include "bench/engine/bench_shaders.h"

#include <array>
#include <vector>

namespace rasterlab::bench {

/// An array for each number that goes into a shader, and for each that comes out.
struct ShadedPoints {
  static constexpr int count = 64 * 64;  ///< a multiple of every number of lanes

  std::array<std::vector<float>, 6> varyings;  ///< normal x, y, z, position x, y, z
  std::array<std::vector<float>, 3> color;
};

#define RASTERLAB_DECLARE_CALLS(simd)                                     \
  namespace simd_##simd {                                                 \
    void shade_wide(const FlatShader& shader, ShadedPoints& points);      \
    void shade_wide(const PhongShader& shader, ShadedPoints& points);     \
    void shade_in_pairs(const FlatShader& shader, ShadedPoints& points);  \
    void shade_in_pairs(const PhongShader& shader, ShadedPoints& points); \
  }
RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_DECLARE_CALLS)
#undef RASTERLAB_DECLARE_CALLS

}  // namespace rasterlab::bench

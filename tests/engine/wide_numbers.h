// Operations of the engine's wide numbers as loops over arrays, for each instruction set.
#pragma once

#include "common/engine/simd_target.h"

#include <cstdint>
#include <span>

namespace rasterlab {

struct ThreeNumbers {
  float a, b, c;
};

struct WideNumbers {
  /// a · b + c of each.
  void (*fused_multiply_add)(std::span<const ThreeNumbers> operands, float* results);
  /// Per colour, whose channels are a, b and c, what pack_texel() gives for its bytes.
  void (*pack_color)(std::span<const ThreeNumbers> colors, std::uint32_t* results);
};

/// Those of an instruction set.
WideNumbers wide_numbers(SimdTarget target);

}  // namespace rasterlab

// The instruction sets the engine is compiled for, and which of them this machine has.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rasterlab {

/// Narrowest first. Every one of them gives the same bytes; wider ones are faster. They are the
/// targets of the library Highway, which calls the last one AVX3.
enum class SimdTarget { scalar, ssse3, sse4, avx2, avx512 };

inline constexpr int simd_target_count = 5;

/// "scalar", "ssse3", "sse4", "avx2", "avx512".
std::string_view name_of(SimdTarget target);

/// The target of that name. Throws InputError, naming the targets there are, when none has it or
/// this build or machine can't run it.
SimdTarget simd_target(std::string_view name);

/// What this build is for and this machine can run, narrowest first; never empty.
std::vector<SimdTarget> supported_simd_targets();

/// The widest of them.
SimdTarget best_simd_target();

}  // namespace rasterlab

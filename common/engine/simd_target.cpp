#include "common/engine/simd_target.h"

#include "common/engine/compiled_simd_targets.h"
#include "common/image/check.h"

#include <hwy/highway.h>

namespace rasterlab {

namespace {

struct Known {
  std::string_view name;
  std::int64_t highway;
  bool compiled = false;
};

constexpr std::array<Known, simd_target_count> known_targets = [] {
  std::array<Known, simd_target_count> known = {{{"scalar", HWY_SCALAR},
                                                 {"ssse3", HWY_SSSE3},
                                                 {"sse4", HWY_SSE4},
                                                 {"avx2", HWY_AVX2},
                                                 {"avx512", HWY_AVX3}}};
#define RASTERLAB_IS_COMPILED(simd) \
  known[static_cast<std::size_t>(SimdTarget::simd)].compiled = true;
  RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_IS_COMPILED)
#undef RASTERLAB_IS_COMPILED
  return known;
}();

}  // namespace

std::string_view name_of(SimdTarget target) {
  return known_targets[static_cast<std::size_t>(target)].name;
}

std::vector<SimdTarget> supported_simd_targets() {
  std::vector<SimdTarget> supported = {SimdTarget::scalar};
  const std::int64_t here = hwy::SupportedTargets();
  for (std::size_t i = 1; i < known_targets.size(); ++i) {
    if (known_targets[i].compiled && (here & known_targets[i].highway) != 0)
      supported.push_back(static_cast<SimdTarget>(i));
  }
  return supported;
}

SimdTarget best_simd_target() {
  return supported_simd_targets().back();
}

SimdTarget simd_target(std::string_view name) {
  std::string names;
  for (const SimdTarget target : supported_simd_targets()) {
    if (name_of(target) == name) return target;
    names += (names.empty() ? "" : ", ") + std::string(name_of(target));
  }
  throw InputError("\"" + std::string(name) + "\" is no SIMD target of this machine; it has " +
                   names);
}

}  // namespace rasterlab

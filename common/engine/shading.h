// How a shader of one's own gets into the engine.
//
// A shader (common/mesh/shader_types.h) is compiled once per instruction set. Put it in a header,
// and in a file of its own, say my_shader.simd.cpp,
//
//   #include "my_shader.h"
//   #include "common/engine/shade_tile.h"
//   RASTERLAB_SHADER(MyShader)
//
// which CMake's `rasterlab_add_simd_sources(my_target my_shader.simd.cpp)` compiles as often as
// needed. Anywhere else:
//
//   #include "common/engine/renderer.h"
//   … shading(my_shader) …
#pragma once

#include "common/engine/compiled_simd_targets.h"
#include "common/engine/kernels.h"

#include <array>

namespace rasterlab {

/// A shader with its uniforms, and the functions it was compiled to. Refers to the shader.
struct Shading {
  const void* shader = nullptr;  ///< nullptr: nothing is shaded, only depth is drawn
  std::array<const ShadingKernels*, simd_target_count> kernels = {};
};

#define RASTERLAB_DECLARE_SHADING(simd)      \
  namespace simd_##simd {                    \
    template <class Shader>                  \
    const ShadingKernels& shading_kernels(); \
  }
RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_DECLARE_SHADING)
#undef RASTERLAB_DECLARE_SHADING

/// The shader for a draw call. Defined by RASTERLAB_SHADER for the type.
template <class Shader>
Shading shading(const Shader& shader) {
  Shading compiled = {&shader, {}};
#define RASTERLAB_TAKE_SHADING(simd)                             \
  compiled.kernels[static_cast<std::size_t>(SimdTarget::simd)] = \
      &simd_##simd::shading_kernels<Shader>();
  RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_TAKE_SHADING)
#undef RASTERLAB_TAKE_SHADING
  return compiled;
}

}  // namespace rasterlab

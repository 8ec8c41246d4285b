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

#include "common/engine/kernels.h"

#include <array>

namespace rasterlab {

/// A shader with its uniforms, and the functions it was compiled to. Refers to the shader.
struct Shading {
  const void* shader = nullptr;  ///< nullptr: nothing is shaded, only depth is drawn
  std::array<const ShadingKernels*, simd_target_count> kernels = {};
};

namespace simd_scalar {
template <class Shader>
const ShadingKernels& shading_kernels();
}
namespace simd_ssse3 {
template <class Shader>
const ShadingKernels& shading_kernels();
}
namespace simd_sse4 {
template <class Shader>
const ShadingKernels& shading_kernels();
}
namespace simd_avx2 {
template <class Shader>
const ShadingKernels& shading_kernels();
}
namespace simd_avx512 {
template <class Shader>
const ShadingKernels& shading_kernels();
}

/// The shader for a draw call. Defined by RASTERLAB_SHADER for the type.
template <class Shader>
Shading shading(const Shader& shader) {
#if defined(__x86_64__)
  return {&shader,
          {&simd_scalar::shading_kernels<Shader>(), &simd_ssse3::shading_kernels<Shader>(),
           &simd_sse4::shading_kernels<Shader>(), &simd_avx2::shading_kernels<Shader>(),
           &simd_avx512::shading_kernels<Shader>()}};
#else
  const ShadingKernels* only = &simd_scalar::shading_kernels<Shader>();
  return {&shader, {only, only, only, only, only}};
#endif
}

}  // namespace rasterlab

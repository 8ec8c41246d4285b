// The shaders as the engine runs them: compiled once per instruction set.
#include "common/engine/shade_tile.h"

#include "07_shaders/shader_list.h"

#include <array>
#include <tuple>

namespace rasterlab::RASTERLAB_SIMD {
namespace {

template <class... Shaders>
constexpr auto functions_of(ShaderTypes<Shaders...>) {
  return std::array{&shading_kernels<Shaders>...};
}

template <class... Lines>
constexpr auto all_functions(const std::tuple<Lines...>&) {
  return std::tuple{functions_of(typename Lines::Types())...};
}

}  // namespace

/// Nobody reads it: that it refers to them makes the compiler emit them.
extern const decltype(all_functions(shader_list)) compiled_shaders;
const decltype(all_functions(shader_list)) compiled_shaders = all_functions(shader_list);

}  // namespace rasterlab::RASTERLAB_SIMD

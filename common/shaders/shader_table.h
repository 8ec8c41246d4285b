// Shaders by name: a table of types, for whoever draws with one that is chosen when the program
// runs.
#pragma once

#include "common/image/check.h"
#include "common/mesh/shader_types.h"
#include "common/shaders/attributes.h"
#include "common/shaders/color_sources.h"
#include "common/shaders/inputs.h"

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace rasterlab {

/// A list of types and nothing else.
template <class... Shaders>
struct ShaderTypes {};

/// A shader that is made from ShaderInputs.
template <ShaderType Shader>
struct NamedShader {
  using Types = ShaderTypes<Shader>;

  std::string_view name;
  std::string_view description;

  /// Calls `use(shader)` with one made from the inputs.
  template <class Use>
  auto make(const ShaderInputs& inputs, const Use& use) const {
    return use(Shader(inputs));
  }
};

/// A surface whose colour, as the mesh and the user have it, is constant or the vertices'.
template <template <class ColorSource> class Surface>
struct NamedSurface {
  using Types = ShaderTypes<Surface<ConstantColor>, Surface<VertexColor>>;

  std::string_view name;
  std::string_view description;

  template <class Use>
  auto make(const ShaderInputs& inputs, const Use& use) const {
    const bool one_color = inputs.color || inputs.mesh.colors.empty();
    return one_color ? use(Surface<ConstantColor>(inputs)) : use(Surface<VertexColor>(inputs));
  }
};

/// A line of the table: shader<MyShader>("my_shader", "what it does"), or, given a template over
/// the colour source alone, shader<MySurface>(…).
template <ShaderType Shader>
constexpr NamedShader<Shader> shader(std::string_view name, std::string_view description) {
  return {name, description};
}
template <template <class ColorSource> class Surface>
constexpr NamedSurface<Surface> shader(std::string_view name, std::string_view description) {
  return {name, description};
}

/// Calls `use(shader)` with the shader of that name, made from the inputs. `table` is a std::tuple
/// of lines; `use` gives the same type for every shader. Throws InputError for a name that is not
/// in the table, and what the shader's constructor throws.
template <class... Lines, class Use>
auto with_shader(const std::tuple<Lines...>& table, std::string_view name,
                 const ShaderInputs& inputs, const Use& use) {
  using Result = decltype(std::get<0>(table).make(inputs, use));
  Result result{};
  const auto used = [&](const auto& line) {
    if (line.name != name) return false;
    result = line.make(inputs, use);
    return true;
  };
  const bool found = std::apply([&](const auto&... lines) { return (used(lines) || ...); }, table);
  if (!found) throw InputError("no shader is called '" + std::string(name) + "'");
  return result;
}

/// Whether the shader of that name may read the vertices' normals, whatever it is made from. False
/// where there is none of that name.
template <class... Lines>
bool reads_vertex_normals(const std::tuple<Lines...>& table, std::string_view name) {
  const auto any_reads = []<class... Shaders>(ShaderTypes<Shaders...>) {
    return (reads_vertex_normals<Shaders>() || ...);
  };
  return std::apply(
      [&](const auto&... lines) {
        return (
            (lines.name == name && any_reads(typename std::decay_t<decltype(lines)>::Types())) ||
            ...);
      },
      table);
}

/// The names and descriptions, in the table's order.
struct ShaderName {
  std::string name;
  std::string description;
};
template <class... Lines>
std::vector<ShaderName> shader_names(const std::tuple<Lines...>& table) {
  return std::apply(
      [](const auto&... lines) {
        return std::vector<ShaderName>{
            {std::string(lines.name), std::string(lines.description)}...};
      },
      table);
}

}  // namespace rasterlab

// A right answer written differently: a table of the triangles that were seen.
#pragma once

#include "common/image/check.h"

#include <map>

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  using ShadedCorners = std::array<typename Shader::template Varyings<float>, 3>;
  std::map<std::uint32_t, ShadedCorners> seen;
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    auto found = seen.find(triangle);
    if (found == seen.end()) {
      const ShadedCorners corners = {shader.vertex(mesh, triangle, 0),
                                     shader.vertex(mesh, triangle, 1),
                                     shader.vertex(mesh, triangle, 2)};
      found = seen.emplace(triangle, corners).first;
    }
    return shader.fragment(surface_point<Shader::template Varyings>(found->second, pixel));
  };
  return draw_mesh(mesh, transforms, cull, frame, shade);
}

}  // namespace rasterlab

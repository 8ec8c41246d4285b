// A right answer written differently: the vertices of all triangles before any pixel.
#pragma once

#include "common/image/check.h"
#include "common/projection/once_a_triangle.h"

#include <vector>

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  std::vector<std::array<typename Shader::template Varyings<float>, 3>> shaded;
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    auto& corners = shaded.emplace_back();
    for (int corner = 0; corner < 3; ++corner) {
      corners[static_cast<std::size_t>(corner)] = shader.vertex(mesh, triangle, corner);
    }
  }
  return draw_mesh(
      mesh, transforms, cull, frame, [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        const auto point = surface_point<Shader::template Varyings>(shaded[triangle], pixel);
        return shader.fragment(point);
      });
}

}  // namespace rasterlab

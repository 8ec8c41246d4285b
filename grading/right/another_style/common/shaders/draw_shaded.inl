// A right answer written differently: a place for every triangle, filled when a pixel first asks.
#pragma once

#include "common/image/check.h"

#include <optional>
#include <vector>

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  using ShadedCorners = std::array<typename Shader::template Varyings<float>, 3>;
  std::vector<std::optional<ShadedCorners>> shaded(mesh.triangles.size());
  return draw_mesh(
      mesh, transforms, cull, frame, [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        std::optional<ShadedCorners>& corners = shaded[triangle];
        if (!corners) {
          corners.emplace();
          for (int i = 0; i < 3; ++i)
            (*corners)[static_cast<std::size_t>(i)] = shader.vertex(mesh, triangle, i);
        }
        return shader.fragment(surface_point<Shader::template Varyings>(*corners, pixel));
      });
}

}  // namespace rasterlab

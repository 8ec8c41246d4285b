// Exercise 07.1; the contract is in draw_shaded.h.
#pragma once

#include "common/image/check.h"
#include "common/projection/once_a_triangle.h"

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  // <solution>
  using ShadedCorners = std::array<typename Shader::template Varyings<float>, 3>;
  auto corners = once_a_triangle<ShadedCorners>([&](std::uint32_t triangle) -> ShadedCorners {
    return {shader.vertex(mesh, triangle, 0), shader.vertex(mesh, triangle, 1),
            shader.vertex(mesh, triangle, 2)};
  });
  return draw_mesh(
      mesh, transforms, cull, frame, [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        return shader.fragment(surface_point<Shader::template Varyings>(corners(triangle), pixel));
      });
  // <starter> throw NotWritten("07.1", mesh, transforms, cull, shader, frame);
  // </solution>
}

}  // namespace rasterlab

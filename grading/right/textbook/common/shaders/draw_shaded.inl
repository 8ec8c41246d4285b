// A right answer written differently: the three vertices of a triangle shaded again for each of its
// pixels.
#pragma once

#include "common/image/check.h"
#include "common/projection/once_a_triangle.h"

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    using Corner = typename Shader::template Varyings<float>;
    const std::array<Corner, 3> corners = {shader.vertex(mesh, triangle, 0),
                                           shader.vertex(mesh, triangle, 1),
                                           shader.vertex(mesh, triangle, 2)};
    return shader.fragment(surface_point<Shader::template Varyings>(corners, pixel));
  };
  return draw_mesh(mesh, transforms, cull, frame, shade);
}

}  // namespace rasterlab

// A right answer written differently: the corners kept from one pixel to the next, the triangle
// they are of beside them.
#pragma once

#include "common/image/check.h"
#include "common/projection/once_a_triangle.h"

namespace rasterlab {

template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame) {
  std::array<typename Shader::template Varyings<float>, 3> corners{};
  std::int64_t corners_of = -1;
  const auto pixel_color = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    if (corners_of != std::int64_t{triangle}) {
      corners_of = triangle;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = shader.vertex(mesh, triangle, static_cast<int>(i));
    }
    return shader.fragment(surface_point<Shader::template Varyings>(corners, pixel));
  };
  return draw_mesh(mesh, transforms, cull, frame, pixel_color);
}

}  // namespace rasterlab

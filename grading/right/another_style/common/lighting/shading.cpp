// A right answer written differently: what a triangle needs is kept until the next comes.
#include "common/lighting/shading.h"

#include "common/image/check.h"
#include "common/lighting/light_vertices.h"
#include "common/lighting/surface_lighting.h"
#include "common/projection/once_a_triangle.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlab {

DrawCounts shade_flat(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  std::int64_t lit_triangle = -1;
  Color color = Color::Zero();
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel&) {
    if (triangle != lit_triangle) color = lighting.light(lighting.face(triangle));
    lit_triangle = triangle;
    return color;
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame) {
  std::array<Color, 3> colors;
  std::int64_t of = -1;
  const std::vector<Color> all = light_vertices(lit_mesh);
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    for (std::size_t i = 0; i < 3 && of != triangle; ++i)
      colors[i] = all[lit_mesh.mesh.triangles[triangle][i]];
    of = triangle;
    return interpolate(colors, pixel.weights);
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  std::array<SurfaceSample<float>, 3> corners;
  std::int64_t of = -1;
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    if (of != triangle) corners = lighting.corners(triangle);
    of = triangle;
    const SurfaceSample<float> seen = interpolate(corners, pixel.weights);
    return lighting.light(seen);
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

}  // namespace rasterlab

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
  // <solution>
  const SurfaceLighting lighting(lit_mesh);
  auto color = once_a_triangle<Color>(
      [&](std::uint32_t triangle) { return lighting.light(lighting.face(triangle)); });
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel&) { return color(triangle); });
  // <starter> throw NotWritten("05.5", lit_mesh, frame);
  // </solution>
}

DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame) {
  // <solution>
  const std::vector<Color> colors = light_vertices(lit_mesh);
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     const auto [a, b, c] = lit_mesh.mesh.triangles[triangle];
                     return interpolate<Color>({colors[a], colors[b], colors[c]}, pixel.weights);
                   });
  // <starter> throw NotWritten("05.5", lit_mesh, frame);
  // </solution>
}

DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame) {
  // <solution>
  const SurfaceLighting lighting(lit_mesh);
  auto corners = once_a_triangle<std::array<SurfaceSample<float>, 3>>(
      [&](std::uint32_t triangle) { return lighting.corners(triangle); });
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     return lighting.light(interpolate(corners(triangle), pixel.weights));
                   });
  // <starter> throw NotWritten("05.5", lit_mesh, frame);
  // </solution>
}

}  // namespace rasterlab

#include "common/lighting/shading.h"

#include "common/lighting/surface_lighting.h"
#include "common/projection/once_a_triangle.h"

#include <array>
#include <cstdint>

namespace rasterlab {

DrawCounts shade_flat(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  auto color = once_a_triangle<Color>(
      [&](std::uint32_t triangle) { return lighting.light(lighting.face(triangle)); });
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel&) { return color(triangle); });
}

DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  auto colors = once_a_triangle<std::array<Color, 3>>([&](std::uint32_t triangle) {
    const std::array<SurfaceSample, 3> corners = lighting.corners(triangle);
    return std::array<Color, 3>{lighting.light(corners[0]), lighting.light(corners[1]),
                                lighting.light(corners[2])};
  });
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     return interpolate(colors(triangle), pixel.weights);
                   });
}

DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  auto corners = once_a_triangle<std::array<SurfaceSample, 3>>(
      [&](std::uint32_t triangle) { return lighting.corners(triangle); });
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     return lighting.light(interpolate(corners(triangle), pixel.weights));
                   });
}

}  // namespace rasterlab

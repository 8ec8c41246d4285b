// A right answer written differently: all faces, or all corners, made before anything is drawn.
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
  std::vector<Color> of_face;
  for (std::uint32_t i = 0; i < lit_mesh.mesh.triangles.size(); ++i) {
    of_face.push_back(lighting.light(lighting.face(i)));
  }
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel&) { return of_face[triangle]; });
}

DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame) {
  const std::vector<Color> at_vertex = light_vertices(lit_mesh);
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) -> Color {
    const Mesh::Triangle& corners = lit_mesh.mesh.triangles[triangle];
    const Color &a = at_vertex[corners[0]], &b = at_vertex[corners[1]], &c = at_vertex[corners[2]];
    return a + pixel.weights.b1 * (b - a) + pixel.weights.b2 * (c - a);
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  std::vector<std::array<SurfaceSample<float>, 3>> corners;
  for (std::uint32_t i = 0; i < lit_mesh.mesh.triangles.size(); ++i)
    corners.push_back(lighting.corners(i));
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    return lighting.light(interpolate(corners[triangle], pixel.weights));
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

}  // namespace rasterlab

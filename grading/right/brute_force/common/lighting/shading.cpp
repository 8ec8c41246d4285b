// A right answer written differently: everything anew at every pixel, weight by weight.
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
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel&) {
                     return lighting.light(lighting.face(triangle));
                   });
}

DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame) {
  const std::vector<Color> colors = light_vertices(lit_mesh);
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     const float weights[] = {1 - pixel.weights.b1 - pixel.weights.b2,
                                              pixel.weights.b1, pixel.weights.b2};
                     Color sum = Color::Zero();
                     for (std::size_t i = 0; i < 3; ++i) {
                       sum += weights[i] * colors[lit_mesh.mesh.triangles[triangle][i]];
                     }
                     return sum;
                   });
}

DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame) {
  const SurfaceLighting lighting(lit_mesh);
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     const float weights[] = {1 - pixel.weights.b1 - pixel.weights.b2,
                                              pixel.weights.b1, pixel.weights.b2};
                     SurfaceSample<float> mixed{Color::Zero(), Color::Zero(), Color::Zero()};
                     const auto corners = lighting.corners(triangle);
                     for (std::size_t i = 0; i < 3; ++i) {
                       mixed.position += weights[i] * corners[i].position;
                       mixed.normal += weights[i] * corners[i].normal;
                       mixed.color += weights[i] * corners[i].color;
                     }
                     mixed.normal = normalized(mixed.normal);
                     return lighting.light(mixed);
                   });
}

}  // namespace rasterlab

// A right answer written differently: the point of the surface by three weights, and its colour
// read before it is lit.
#include "common/texture/textured_mesh.h"

#include "common/image/check.h"
#include "common/lighting/surface_lighting.h"
#include "common/projection/once_a_triangle.h"

#include <array>
#include <cstdint>

namespace rasterlab {

void require_texture_coordinates(const Mesh& mesh) {
  if (mesh.texture_coordinates.empty()) {
    throw InputError("the mesh has no texture coordinates, by which a texture is laid on it");
  }
}

DrawCounts draw_textured_mesh(const LitMesh& lit_mesh, const Sampler& sampler, Frame& frame) {
  require_texture_coordinates(lit_mesh.mesh);
  const SurfaceLighting lighting(lit_mesh);
  const auto three = [](const CornerWeights<float>& w, float sum) {
    return std::array<float, 3>{sum - w.b1 - w.b2, w.b1, w.b2};
  };
  return draw_mesh(lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     Eigen::Vector2f uv = Eigen::Vector2f::Zero(), dx = uv, dy = uv;
                     for (std::size_t i = 0; i < 3; ++i) {
                       const Eigen::Vector2f& corner =
                           lit_mesh.mesh.texture_coordinates[lit_mesh.mesh.triangles[triangle][i]];
                       uv += three(pixel.weights, 1)[i] * corner;
                       dx += three(pixel.weights_dx, 0)[i] * corner;
                       dy += three(pixel.weights_dy, 0)[i] * corner;
                     }
                     SurfaceSample<float> point =
                         interpolate(lighting.corners(triangle), pixel.weights);
                     point.color = sample(sampler, Footprint<float>{uv, dx, dy});
                     return lighting.light(point);
                   });
}

}  // namespace rasterlab

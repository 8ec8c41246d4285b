// A right answer written differently: the mesh coloured by its texture pixel after pixel, nothing
// kept between pixels.
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
  return draw_mesh(
      lit_mesh.mesh, lit_mesh.transforms, lit_mesh.cull, frame,
      [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        const Mesh::Triangle& corners = lit_mesh.mesh.triangles[triangle];
        const auto& uv = lit_mesh.mesh.texture_coordinates;
        const Eigen::Vector2f a = uv[corners[0]];
        const Eigen::Vector2f b = uv[corners[1]] - a, c = uv[corners[2]] - a;
        const auto mixed = [&](const CornerWeights<float>& weights) {
          return Eigen::Vector2f(weights.b1 * b + weights.b2 * c);
        };
        SurfaceSample<float> seen = interpolate(lighting.corners(triangle), pixel.weights);
        seen.color =
            sample(sampler, Footprint<float>{a + mixed(pixel.weights), mixed(pixel.weights_dx),
                                             mixed(pixel.weights_dy)});
        return lighting.light(seen);
      });
}

}  // namespace rasterlab

#include "common/texture/textured_mesh.h"

#include "common/image/check.h"
#include "common/lighting/surface_lighting.h"
#include "common/projection/once_a_triangle.h"

#include <array>
#include <cstdint>

namespace rasterlab {

// <solution>
namespace {

using TextureCorners = std::array<Eigen::Vector2f, 3>;

TextureCorners texture_corners(const Mesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.texture_coordinates[a], mesh.texture_coordinates[b], mesh.texture_coordinates[c]};
}

/// What of the texture a pixel sees.
Footprint<float> footprint(const TextureCorners& corners, const TrianglePixel& pixel) {
  const Eigen::Vector2f to_1 = corners[1] - corners[0];
  const Eigen::Vector2f to_2 = corners[2] - corners[0];
  return {interpolate(corners, pixel.weights),
          pixel.weights_dx.b1 * to_1 + pixel.weights_dx.b2 * to_2,
          pixel.weights_dy.b1 * to_1 + pixel.weights_dy.b2 * to_2};
}

}  // namespace
// </solution>

void require_texture_coordinates(const Mesh& mesh) {
  if (mesh.texture_coordinates.empty()) {
    throw InputError("the mesh has no texture coordinates, by which a texture is laid on it");
  }
}

DrawCounts draw_textured_mesh(const LitMesh& lit_mesh, const Sampler& sampler, Frame& frame) {
  // <solution>
  const Mesh& mesh = lit_mesh.mesh;
  require_texture_coordinates(mesh);
  const SurfaceLighting lighting(lit_mesh);
  auto samples = once_a_triangle<std::array<SurfaceSample<float>, 3>>(
      [&](std::uint32_t triangle) { return lighting.corners(triangle); });
  auto coordinates = once_a_triangle<TextureCorners>(
      [&](std::uint32_t triangle) { return texture_corners(mesh, triangle); });
  return draw_mesh(mesh, lit_mesh.transforms, lit_mesh.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel& pixel) {
                     SurfaceSample<float> sample = interpolate(samples(triangle), pixel.weights);
                     sample.color =
                         rasterlab::sample(sampler, footprint(coordinates(triangle), pixel));
                     return lighting.light(sample);
                   });
  // <starter> throw NotWritten("06.2", lit_mesh, sampler, frame);
  // </solution>
}

}  // namespace rasterlab

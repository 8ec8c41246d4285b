// A right answer written differently: u and v as the columns of a matrix, what a triangle needs
// made before all pixels.
#include "common/texture/textured_mesh.h"

#include "common/image/check.h"
#include "common/lighting/surface_lighting.h"
#include "common/projection/once_a_triangle.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlab {

namespace {

struct Laid {
  std::array<SurfaceSample<float>, 3> samples;
  Eigen::Matrix<float, 2, 3> uv;
};

}  // namespace

void require_texture_coordinates(const Mesh& mesh) {
  if (mesh.texture_coordinates.empty()) {
    throw InputError("the mesh has no texture coordinates, by which a texture is laid on it");
  }
}

DrawCounts draw_textured_mesh(const LitMesh& lit_mesh, const Sampler& sampler, Frame& frame) {
  const Mesh& mesh = lit_mesh.mesh;
  require_texture_coordinates(mesh);
  const SurfaceLighting lighting(lit_mesh);
  std::vector<Laid> laid(mesh.triangles.size());
  for (std::uint32_t triangle = 0; triangle < laid.size(); ++triangle) {
    laid[triangle].samples = lighting.corners(triangle);
    for (int i = 0; i < 3; ++i) {
      laid[triangle].uv.col(i) =
          mesh.texture_coordinates[mesh.triangles[triangle][static_cast<std::size_t>(i)]];
    }
  }
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    const Eigen::Matrix<float, 2, 3>& uv = laid[triangle].uv;
    const auto along = [&uv](const CornerWeights<float>& w) -> Eigen::Vector2f {
      return (uv.col(1) - uv.col(0)) * w.b1 + (uv.col(2) - uv.col(0)) * w.b2;
    };
    Footprint<float> seen;
    seen.uv = uv.col(0) + along(pixel.weights);
    seen.dx = along(pixel.weights_dx);
    seen.dy = along(pixel.weights_dy);
    SurfaceSample<float> point = interpolate(laid[triangle].samples, pixel.weights);
    point.color = sample(sampler, seen);
    return lighting.light(point);
  };
  return draw_mesh(mesh, lit_mesh.transforms, lit_mesh.cull, frame, shade);
}

}  // namespace rasterlab

#include "common/lighting/surface_lighting.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/projection/eye.h"
#include "common/projection/normal_matrix.h"

namespace rasterlab {

SurfaceSample<float> interpolate(const std::array<SurfaceSample<float>, 3>& corners,
                                 const CornerWeights<float>& weights) {
  const auto mix = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                       const Eigen::Vector3f& c) {
    return rasterlab::interpolate<Eigen::Vector3f>({a, b, c}, weights);
  };
  const auto& [a, b, c] = corners;
  return {mix(a.position, b.position, c.position),
          mix(a.normal, b.normal, c.normal).stableNormalized(), mix(a.color, b.color, c.color)};
}

SurfaceLighting::SurfaceLighting(const LitMesh& lit_mesh)
    : lit_mesh_(lit_mesh),
      normal_matrix_(normal_matrix(lit_mesh.transforms.model)),
      eye_(eye_of(lit_mesh.transforms)) {}

Eigen::Vector3f SurfaceLighting::world_position(std::uint32_t vertex) const {
  return (lit_mesh_.transforms.model * lit_mesh_.mesh.positions[vertex].homogeneous()).head<3>();
}

Color SurfaceLighting::vertex_color(std::uint32_t vertex) const {
  if (lit_mesh_.color) return *lit_mesh_.color;
  return lit_mesh_.mesh.colors.empty() ? default_color() : lit_mesh_.mesh.colors[vertex];
}

SurfaceSample<float> SurfaceLighting::vertex(std::uint32_t vertex) const {
  const Mesh& mesh = lit_mesh_.mesh;
  if (mesh.normals.empty()) throw CheckError("a mesh without normals can only be shaded flat");
  return {world_position(vertex), transform_normal(normal_matrix_, mesh.normals[vertex]),
          vertex_color(vertex)};
}

std::array<SurfaceSample<float>, 3> SurfaceLighting::corners(std::uint32_t triangle) const {
  const auto [a, b, c] = lit_mesh_.mesh.triangles[triangle];
  return {vertex(a), vertex(b), vertex(c)};
}

SurfaceSample<float> SurfaceLighting::face(std::uint32_t triangle) const {
  const auto [a, b, c] = lit_mesh_.mesh.triangles[triangle];
  return {(world_position(a) + world_position(b) + world_position(c)) / 3,
          transform_normal(normal_matrix_, face_normal(lit_mesh_.mesh, triangle)),
          (vertex_color(a) + vertex_color(b) + vertex_color(c)) / 3};
}

}  // namespace rasterlab

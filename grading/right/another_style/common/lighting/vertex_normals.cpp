// A right answer written differently: first which triangles each vertex has, then vertex by vertex.
#include "common/lighting/vertex_normals.h"

namespace rasterlab {
namespace {

Eigen::Vector3d unit_normal(const Mesh& mesh, const Mesh::Triangle& triangle) {
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
    return mesh.positions[triangle[i]].cast<double>();
  };
  const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(1));
  const double largest = normal.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d((normal / largest).normalized()) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d mean_direction(const std::vector<Eigen::Vector3d>& normals) {
  if (normals.empty()) return Eigen::Vector3d::UnitZ();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& normal : normals)
    mean += normal / static_cast<double>(normals.size());
  return mean.norm() <= 1e-5 ? normals.front() : Eigen::Vector3d(mean.normalized());
}

}  // namespace

std::vector<Eigen::Vector3f> vertex_normals(const Mesh& mesh) {
  std::vector<std::vector<Eigen::Vector3d>> around(mesh.positions.size());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d normal = unit_normal(mesh, triangle);
    if (normal == Eigen::Vector3d::Zero()) continue;
    for (const std::uint32_t vertex : triangle) around[vertex].push_back(normal);
  }
  std::vector<Eigen::Vector3f> result(around.size());
  for (std::size_t i = 0; i < around.size(); ++i)
    result[i] = mean_direction(around[i]).cast<float>();
  return result;
}

}  // namespace rasterlab

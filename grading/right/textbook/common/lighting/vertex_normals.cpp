// A right answer written differently: the normals of all faces first, then those round each vertex
// added up.
#include "common/lighting/vertex_normals.h"

#include "common/image/check.h"

namespace rasterlab {

std::vector<Eigen::Vector3f> vertex_normals(const Mesh& mesh) {
  const auto corner = [&mesh](std::uint32_t vertex) {
    return mesh.positions[vertex].cast<double>().eval();
  };
  std::vector<std::vector<Eigen::Vector3d>> around(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d across = (corner(b) - corner(a)).cross(corner(c) - corner(a));
    const Eigen::Vector3d normal = across.stableNormalized();
    if (normal == Eigen::Vector3d::Zero()) continue;
    for (const std::uint32_t vertex : {a, b, c}) around[vertex].push_back(normal);
  }
  std::vector<Eigen::Vector3f> result;
  for (const auto& normals : around) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : normals)
      mean += normal / static_cast<double>(normals.size());
    if (normals.empty()) {
      result.push_back(Eigen::Vector3f::UnitZ());
    } else {
      result.push_back((mean.norm() > 1e-5 ? mean.normalized() : normals.front()).cast<float>());
    }
  }
  return result;
}

}  // namespace rasterlab

// A right answer written differently: each vertex looks through the normals of all triangles that
// name it, listed once.
#include "common/lighting/vertex_normals.h"

#include <algorithm>

namespace rasterlab {

std::vector<Eigen::Vector3f> vertex_normals(const Mesh& mesh) {
  std::vector<std::vector<Eigen::Vector3d>> around(mesh.positions.size());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[triangle[i]].cast<double>();
    Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double scale = normal.cwiseAbs().maxCoeff();
    if (!(scale > 0)) continue;
    normal = (normal / scale).normalized();
    for (std::size_t i = 0; i < 3; ++i) around[triangle[i]].push_back(normal);
  }
  std::vector<Eigen::Vector3f> normals;
  for (const std::vector<Eigen::Vector3d>& of_faces : around) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : of_faces) mean += normal / double(of_faces.size());
    if (of_faces.empty()) mean = Eigen::Vector3d::UnitZ();
    if (mean.norm() < 1e-5) mean = of_faces.front();
    normals.push_back(mean.normalized().cast<float>());
  }
  return normals;
}

}  // namespace rasterlab

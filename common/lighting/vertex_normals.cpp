#include "common/lighting/vertex_normals.h"

#include "common/image/check.h"

namespace rasterlab {
// <solution>
namespace {

// What is known of a vertex while its triangles are gone through.
struct Around {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::UnitZ();
  int count = 0;
};

// In double precision, where neither tiny nor huge triangles lose their direction.
Eigen::Vector3d face_normal(const Mesh& mesh, const Mesh::Triangle& triangle) {
  const Eigen::Vector3d a = mesh.positions[triangle[0]].cast<double>();
  const Eigen::Vector3d b = mesh.positions[triangle[1]].cast<double>();
  const Eigen::Vector3d c = mesh.positions[triangle[2]].cast<double>();
  return (b - a).cross(c - a).stableNormalized();
}

}  // namespace
// </solution>

std::vector<Eigen::Vector3f> vertex_normals(const Mesh& mesh) {
  // <solution>
  std::vector<Around> vertices(mesh.positions.size());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d normal = face_normal(mesh, triangle);
    if (normal.isZero(0)) continue;
    for (const std::uint32_t corner : triangle) {
      Around& vertex = vertices[corner];
      if (vertex.count == 0) vertex.first = normal;
      vertex.sum += normal;
      ++vertex.count;
    }
  }
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(vertices.size());
  for (const Around& vertex : vertices) {
    const bool cancelled = vertex.sum.norm() <= 1e-5 * vertex.count;
    normals.emplace_back((cancelled ? vertex.first : vertex.sum.normalized()).cast<float>());
  }
  return normals;
  // <starter> throw NotWritten("05.1", mesh);
  // </solution>
}

}  // namespace rasterlab

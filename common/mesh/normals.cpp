#include "common/mesh/normals.h"

#include <cmath>

namespace rasterlab {
namespace {

/// Between two edges that leave a corner; 0 where one has no length. atan2 is exact for small
/// angles, unlike acos.
float angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Eigen::Vector3f face_normal(const Mesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3d origin = mesh.positions[a].cast<double>();
  const Eigen::Vector3d normal =
      (mesh.positions[b].cast<double>() - origin).cross(mesh.positions[c].cast<double>() - origin);
  const double length = normal.norm();
  if (!(length > 0)) return Eigen::Vector3f::Zero();
  return (normal / length).cast<float>();
}

std::vector<Eigen::Vector3f> face_normals(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(mesh.triangles.size());
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    normals.push_back(face_normal(mesh, triangle));
  }
  return normals;
}

std::vector<Eigen::Vector3f> angle_weighted_normals(const Mesh& mesh) {
  const std::vector<Eigen::Vector3f> of_face = face_normals(mesh);
  const std::vector<std::uint32_t> joined = join_by_position(mesh.positions);
  std::vector<Eigen::Vector3f> sums(mesh.positions.size(), Eigen::Vector3f::Zero());
  std::vector<Eigen::Vector3f> first(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const Mesh::Triangle& triangle = mesh.triangles[face];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3f& here = mesh.positions[triangle[corner]];
      const float angle = angle_between(mesh.positions[triangle[(corner + 1) % 3]] - here,
                                        mesh.positions[triangle[(corner + 2) % 3]] - here);
      const std::uint32_t vertex = joined[triangle[corner]];
      sums[vertex] += angle * of_face[face];
      if (first[vertex].isZero(0)) first[vertex] = of_face[face];
    }
  }
  std::vector<Eigen::Vector3f> normals(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
    const Eigen::Vector3f& sum = sums[joined[vertex]];
    const Eigen::Vector3f& fallback = first[joined[vertex]];
    // What rounding leaves of opposite faces is no direction.
    if (sum.norm() > 1e-5F) {
      normals[vertex] = sum.normalized();
    } else {
      normals[vertex] = fallback.isZero(0) ? Eigen::Vector3f(Eigen::Vector3f::UnitZ()) : fallback;
    }
  }
  return normals;
}

}  // namespace rasterlab

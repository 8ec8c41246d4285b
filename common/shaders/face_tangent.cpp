#include "common/shaders/face_tangent.h"

#include "common/image/check.h"

namespace rasterlab {

// <solution>
namespace {

/// A unit vector at a right angle to `normal`: one of many.
Eigen::Vector3d any_perpendicular(const Eigen::Vector3d& normal) {
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(least);
  return (axis - axis.dot(normal) * normal).normalized();
}

}  // namespace
// </solution>

FaceTangent face_tangent(const std::array<Eigen::Vector3f, 3>& corners,
                         const std::array<Eigen::Vector2f, 3>& texture_coordinates) {
  // <solution>
  const Eigen::Vector3d first = corners[0].cast<double>();
  const Eigen::Vector3d edge_1 = corners[1].cast<double>() - first;
  const Eigen::Vector3d edge_2 = corners[2].cast<double>() - first;
  const Eigen::Vector2d first_uv = texture_coordinates[0].cast<double>();
  const Eigen::Vector2d uv_1 = texture_coordinates[1].cast<double>() - first_uv;
  const Eigen::Vector2d uv_2 = texture_coordinates[2].cast<double>() - first_uv;

  const double determinant = uv_1.x() * uv_2.y() - uv_2.x() * uv_1.y();
  const double handedness = determinant < 0 ? -1 : 1;
  const Eigen::Vector3d along_u = handedness * (uv_2.y() * edge_1 - uv_1.y() * edge_2);
  const double length = along_u.stableNorm();
  if (determinant == 0 || !(length > 0)) {
    const Eigen::Vector3d normal = edge_1.cross(edge_2).stableNormalized();
    return {any_perpendicular(normal).cast<float>(), 1};
  }
  return {(along_u / length).cast<float>(), static_cast<float>(handedness)};
  // <starter> throw NotWritten("07.4", corners, texture_coordinates);
  // </solution>
}

}  // namespace rasterlab

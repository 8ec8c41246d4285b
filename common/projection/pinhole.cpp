#include "common/projection/pinhole.h"

#include "common/projection/look_at.h"

#include <limits>

namespace rasterlab {

Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at_point,
                                const Eigen::Vector3f& up) {
  // The other camera, y up and looking along −z, turned half way round its x axis.
  return Eigen::Vector4f(1, -1, -1, 1).asDiagonal() * look_at(eye, look_at_point, -up);
}

Eigen::Matrix<float, 3, 4> canonical_projection() {
  return Eigen::Matrix<float, 3, 4>::Identity();
}

Eigen::Matrix3f calibration(float focal_length, int width, int height) {
  Eigen::Matrix3f matrix;
  matrix << focal_length, 0, static_cast<float>(width) / 2,  //
      0, focal_length, static_cast<float>(height) / 2,       //
      0, 0, 1;
  return matrix;
}

std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration) {
  const Eigen::Matrix<float, 3, 4> to_pixels =
      calibration * canonical_projection() * world_to_camera;
  std::vector<Eigen::Vector3f> projected;
  projected.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f pixel = to_pixels * point.homogeneous();
    const float depth = pixel.z();
    constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
    projected.emplace_back(depth > 0 ? pixel.x() / depth : nowhere,
                           depth > 0 ? pixel.y() / depth : nowhere, depth);
  }
  return projected;
}

}  // namespace rasterlab

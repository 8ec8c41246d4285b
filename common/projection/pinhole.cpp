#include "common/projection/pinhole.h"

#include "common/image/check.h"
#include "common/projection/look_at.h"

#include <limits>

namespace rasterlab {

Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at_point,
                                const Eigen::Vector3f& up) {
  // <solution>
  // The other camera, y up and looking along −z, turned half way round its x axis.
  return Eigen::Vector4f(1, -1, -1, 1).asDiagonal() * look_at(eye, look_at_point, -up);
  // <starter> throw NotWritten("04.6", eye, look_at_point, up);
  // </solution>
}

Eigen::Matrix<float, 3, 4> canonical_projection() {
  // <solution>
  return Eigen::Matrix<float, 3, 4>::Identity();
  // <starter> throw NotWritten("04.6");
  // </solution>
}

Eigen::Matrix3f calibration(float focal_length, int width, int height) {
  // <solution>
  Eigen::Matrix3f matrix;
  matrix << focal_length, 0, static_cast<float>(width) / 2,  //
      0, focal_length, static_cast<float>(height) / 2,       //
      0, 0, 1;
  return matrix;
  // <starter> throw NotWritten("04.6", focal_length, width, height);
  // </solution>
}

std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration) {
  // <solution>
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
  // <starter> throw NotWritten("04.6", points, world_to_camera, calibration);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: without a matrix where none is needed.
#include "common/projection/pinhole.h"

#include "common/image/check.h"
#include "common/projection/look_at.h"

#include <limits>

namespace rasterlab {

Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at_point,
                                const Eigen::Vector3f& up) {
  const Eigen::Vector3f down = -up;
  const Eigen::Matrix4f other = look_at(eye, look_at_point, down);
  Eigen::Matrix4f m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      m(row, column) = row == 1 || row == 2 ? -other(row, column) : other(row, column);
    }
  }
  return m;
}

Eigen::Matrix<float, 3, 4> canonical_projection() {
  Eigen::Matrix<float, 3, 4> m = Eigen::Matrix<float, 3, 4>::Zero();
  for (int i = 0; i < 3; ++i) m(i, i) = 1;
  return m;
}

Eigen::Matrix3f calibration(float focal_length, int width, int height) {
  const auto half = [](int side) { return static_cast<float>(side) / 2; };
  Eigen::Matrix3f k;
  k << focal_length, 0, half(width), 0, focal_length, half(height), 0, 0, 1;
  return k;
}

std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration) {
  std::vector<Eigen::Vector3f> result;
  for (const Eigen::Vector3f& point : points) {
    double in_camera[3];
    for (int i = 0; i < 3; ++i) {
      in_camera[i] = world_to_camera(i, 3);
      for (int j = 0; j < 3; ++j) in_camera[i] += double(world_to_camera(i, j)) * point[j];
    }
    const double z = in_camera[2];
    const float nowhere = std::numeric_limits<float>::quiet_NaN();
    float u = nowhere, v = nowhere;
    if (z > 0) {
      u = float(calibration(0, 0) * in_camera[0] / z + calibration(0, 1) * in_camera[1] / z +
                calibration(0, 2));
      v = float(calibration(1, 0) * in_camera[0] / z + calibration(1, 1) * in_camera[1] / z +
                calibration(1, 2));
    }
    result.push_back({u, v, static_cast<float>(z)});
  }
  return result;
}

}  // namespace rasterlab

// A right answer written differently: all points at once, as the columns of a matrix.
#include "common/projection/pinhole.h"

#include "common/image/check.h"
#include "common/projection/look_at.h"

#include <cmath>
#include <limits>

namespace rasterlab {

Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at_point,
                                const Eigen::Vector3f& up) {
  Eigen::Matrix4f half_turn = Eigen::Matrix4f::Identity();
  half_turn(1, 1) = half_turn(2, 2) = -1;
  return half_turn * look_at(eye, look_at_point, Eigen::Vector3f(-up.x(), -up.y(), -up.z()));
}

Eigen::Matrix<float, 3, 4> canonical_projection() {
  return Eigen::Matrix4f::Identity().topRows<3>();
}

Eigen::Matrix3f calibration(float focal_length, int width, int height) {
  Eigen::Matrix3f k = Eigen::Vector3f(focal_length, focal_length, 1).asDiagonal();
  k.col(2).head<2>() = Eigen::Vector2f(float(width), float(height)) / 2;
  return k;
}

std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix4Xf columns = Eigen::Matrix4Xf::Ones(4, count);
  for (Eigen::Index i = 0; i < count; ++i)
    columns.col(i).head<3>() = points[static_cast<std::size_t>(i)];
  const Eigen::Matrix3Xf seen =
      calibration * (canonical_projection() * (world_to_camera * columns));
  std::vector<Eigen::Vector3f> result(points.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const float depth = seen(2, i);
    const float nowhere = std::nanf("");
    Eigen::Vector3f& point = result[static_cast<std::size_t>(i)];
    point = {nowhere, nowhere, depth};
    if (depth > 0) point.head<2>() = seen.col(i).head<2>() / depth;
  }
  return result;
}

}  // namespace rasterlab

// A right answer written differently: the camera's axes by the contract's cross products; x, y and
// z divided point by point.
#include "common/projection/pinhole.h"

#include "common/image/check.h"
#include "common/projection/look_at.h"

#include <limits>

namespace rasterlab {

Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at_point,
                                const Eigen::Vector3f& up) {
  // Where up or the goal say nothing, look_at() knows what to do; its axes y and z are turned over.
  Eigen::Matrix4f m = look_at(eye, look_at_point, -up);
  m.row(1) = -m.row(1).eval();
  m.row(2) = -m.row(2).eval();
  return m;
}

Eigen::Matrix<float, 3, 4> canonical_projection() {
  Eigen::Matrix<float, 3, 4> m;
  m << Eigen::Matrix3f::Identity(), Eigen::Vector3f::Zero();
  return m;
}

Eigen::Matrix3f calibration(float focal_length, int width, int height) {
  Eigen::Matrix3f k = Eigen::Matrix3f::Identity();
  k(0, 0) = k(1, 1) = focal_length;
  k(0, 2) = 0.5F * static_cast<float>(width);
  k(1, 2) = 0.5F * static_cast<float>(height);
  return k;
}

std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration) {
  std::vector<Eigen::Vector3f> result;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector4f in_camera =
        world_to_camera * Eigen::Vector4f(point.x(), point.y(), point.z(), 1);
    const Eigen::Vector3f seen = calibration * (canonical_projection() * in_camera);
    Eigen::Vector3f uv_depth(seen.x() / seen.z(), seen.y() / seen.z(), in_camera.z());
    if (!(uv_depth.z() > 0))
      uv_depth.head<2>().setConstant(std::numeric_limits<float>::quiet_NaN());
    result.push_back(uv_depth);
  }
  return result;
}

}  // namespace rasterlab

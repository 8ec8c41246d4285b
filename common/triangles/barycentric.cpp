#include "common/triangles/barycentric.h"

namespace rasterlab {

Eigen::Vector3d barycentric(const Corners& corners, const Eigen::Vector2d& point) {
  const auto area = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const Eigen::Vector2d u = corners[1] - corners[0];
  const Eigen::Vector2d v = corners[2] - corners[0];
  const Eigen::Vector2d p = point - corners[0];
  const double whole = area(u, v);
  if (whole == 0) return Eigen::Vector3d::Constant(-1);
  const double w1 = area(p, v) / whole;
  const double w2 = area(u, p) / whole;
  return {1 - w1 - w2, w1, w2};
}

}  // namespace rasterlab

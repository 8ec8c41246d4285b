#include "common/mesh/triangulate.h"

#include <cmath>
#include <cstddef>

namespace rasterlab {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t most_corners_to_clip = 1024;

/// Twice the signed area of the polygon's shadow in each coordinate plane.
Eigen::Vector3d newell_normal(std::span<const Eigen::Vector3f> polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon[0].cast<double>();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += (polygon[i].cast<double>() - origin).cross(polygon[i + 1].cast<double>() - origin);
  }
  return normal;
}

/// The polygon seen along the axis where it shows the greatest area, counter-clockwise.
Points project(std::span<const Eigen::Vector3f> polygon) {
  const Eigen::Vector3d normal = newell_normal(polygon);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index first = (axis + 1) % 3;
  const Eigen::Index second = (axis + 2) % 3;
  const bool turned = normal[axis] < 0;
  Points points;
  points.reserve(polygon.size());
  for (const Eigen::Vector3f& corner : polygon) {
    points.emplace_back(corner[turned ? second : first], corner[turned ? first : second]);
  }
  return points;
}

/// Twice the signed area of a triangle; positive when it is counter-clockwise.
double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_convex(const Points& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (doubled_area(points[i], points[(i + 1) % count], points[(i + 2) % count]) < 0) return false;
  }
  return true;
}

void cut_into_fan(std::size_t corners, Triangles& triangles) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
}

/// Cuts off one ear after the other: a convex corner whose triangle contains no other corner.
class EarClipper {
 public:
  explicit EarClipper(const Points& points) : points_(points) {
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_.push_back((i + 1) % count);
      previous_.push_back((i + count - 1) % count);
    }
  }

  void clip(Triangles& triangles) {
    std::uint32_t corner = 0;
    std::size_t left = points_.size();
    std::size_t passed = 0;
    while (left > 3) {
      // When no corner is an ear, as in a polygon that crosses itself, any is cut off.
      if (is_ear(corner) || passed > left) {
        triangles.push_back({previous_[corner], corner, next_[corner]});
        next_[previous_[corner]] = next_[corner];
        previous_[next_[corner]] = previous_[corner];
        --left;
        passed = 0;
      }
      corner = next_[corner];
      ++passed;
    }
    triangles.push_back({previous_[corner], corner, next_[corner]});
  }

 private:
  bool is_ear(std::uint32_t corner) const {
    const Eigen::Vector2d& a = points_[previous_[corner]];
    const Eigen::Vector2d& b = points_[corner];
    const Eigen::Vector2d& c = points_[next_[corner]];
    if (!(doubled_area(a, b, c) > 0)) return false;
    for (std::uint32_t i = next_[next_[corner]]; i != previous_[corner]; i = next_[i]) {
      const Eigen::Vector2d& p = points_[i];
      // A polygon that touches itself passes through a corner of the ear again.
      if (p == a || p == b || p == c) continue;
      if (doubled_area(a, b, p) >= 0 && doubled_area(b, c, p) >= 0 && doubled_area(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }

  const Points& points_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> previous_;
};

}  // namespace

void triangulate(std::span<const Eigen::Vector3f> polygon,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  triangles.clear();
  if (polygon.size() == 3 || polygon.size() > most_corners_to_clip) {
    cut_into_fan(polygon.size(), triangles);
    return;
  }
  const Points points = project(polygon);
  if (is_convex(points)) {
    cut_into_fan(polygon.size(), triangles);
  } else {
    EarClipper(points).clip(triangles);
  }
}

}  // namespace rasterlab

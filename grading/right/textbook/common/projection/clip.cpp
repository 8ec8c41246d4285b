// A right answer written differently: inside and outside as in the paper: what goes in, what comes
// out.
#include "common/projection/clip.h"

#include "common/image/check.h"

#include <algorithm>
#include <utility>

namespace rasterlab {
namespace {

template <class Point>
typename Point::Scalar near_distance(const Point& p) {
  return p.z() + p.w();
}

// What clip_homogeneous cuts, to be rounded when all planes have.
struct DoubleVertex {
  Eigen::Vector4d position;
  Eigen::Vector3d weights;
};

ClipPolygon corners_of(const ClipTriangle& triangle) {
  const Eigen::Matrix3f unit = Eigen::Matrix3f::Identity();
  return {{triangle[0], unit.col(0)}, {triangle[1], unit.col(1)}, {triangle[2], unit.col(2)}};
}

template <class Vertex, class Number>
Vertex meet(const Vertex& inner, Number d_inner, const Vertex& outer, Number d_outer) {
  const Number t = d_inner / (d_inner - d_outer);
  Vertex cut = inner;
  cut.position += t * (outer.position - inner.position);
  cut.weights += t * (outer.weights - inner.weights);
  return cut;
}

template <class Distance>
void cut_off(std::vector<DoubleVertex>& polygon, Distance distance) {
  const std::vector<DoubleVertex> before = std::exchange(polygon, {});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const DoubleVertex& current = before[i];
    const DoubleVertex& next = before[i + 1 < before.size() ? i + 1 : 0];
    const double d_current = distance(current.position), d_next = distance(next.position);
    if (d_current >= 0) {
      polygon.push_back(current);
      if (!(d_next >= 0)) polygon.push_back(meet(current, d_current, next, d_next));
    } else if (d_next >= 0) {
      polygon.push_back(meet(next, d_next, current, d_current));
    }
  }
}

}  // namespace

ClipPolygon clip_drop(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  const ClipPolygon corners = corners_of(triangle);
  const bool all_seen = std::all_of(corners.begin(), corners.end(), [](const ClipVertex& corner) {
    return near_distance(corner.position) >= 0;
  });
  return all_seen ? corners : ClipPolygon();
}

ClipPolygon clip_near(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  // As a rung it cuts each edge the way round the triangle goes: not always from the inside.
  const ClipPolygon corners = corners_of(triangle);
  ClipPolygon left;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipVertex &a = corners[i], &b = corners[(i + 1) % 3];
    const float d_a = near_distance(a.position), d_b = near_distance(b.position);
    const bool a_seen = d_a >= 0, b_seen = d_b >= 0;
    if (a_seen) left.push_back(a);
    if (a_seen != b_seen) left.push_back(meet(a, d_a, b, d_b));
  }
  return left;
}

ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard) {
  std::vector<DoubleVertex> polygon;
  for (const ClipVertex& corner : corners_of(triangle)) {
    polygon.push_back({corner.position.cast<double>(), corner.weights.cast<double>()});
  }
  const double x = guard.x(), y = guard.y();
  cut_off(polygon, near_distance<Eigen::Vector4d>);
  cut_off(polygon, [x](const Eigen::Vector4d& p) { return x * p.w() + p.x(); });
  cut_off(polygon, [x](const Eigen::Vector4d& p) { return x * p.w() - p.x(); });
  cut_off(polygon, [y](const Eigen::Vector4d& p) { return y * p.w() + p.y(); });
  cut_off(polygon, [y](const Eigen::Vector4d& p) { return y * p.w() - p.y(); });
  ClipPolygon left;
  for (const DoubleVertex& vertex : polygon) {
    left.push_back({vertex.position.cast<float>(), vertex.weights.cast<float>()});
  }
  return left;
}

}  // namespace rasterlab

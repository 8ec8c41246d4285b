#include "common/projection/clip.h"

#include "common/image/check.h"

namespace rasterlab {
// <solution>
namespace {

ClipPolygon whole(const ClipTriangle& triangle) {
  return {{triangle[0], Eigen::Vector3f::UnitX()},
          {triangle[1], Eigen::Vector3f::UnitY()},
          {triangle[2], Eigen::Vector3f::UnitZ()}};
}

// A ClipVertex in double precision, as long as planes still cut.
struct WideVertex {
  Eigen::Vector4d position;
  Eigen::Vector3d weights;
};

// Where the way from a to b meets a plane that is d_a and d_b away.
template <class Vertex, class Number>
Vertex cut(const Vertex& a, Number d_a, const Vertex& b, Number d_b) {
  const Number t = d_a / (d_a - d_b);
  return {a.position + t * (b.position - a.position), a.weights + t * (b.weights - a.weights)};
}

template <class Point>
auto distance_to_near(const Point& p) {
  return p.z() + p.w();
}

template <class Distance>
std::vector<WideVertex> clip_at(const std::vector<WideVertex>& polygon, const Distance& distance) {
  std::vector<WideVertex> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const WideVertex& a = polygon[i];
    const WideVertex& b = polygon[(i + 1) % polygon.size()];
    const double d_a = distance(a.position);
    const double d_b = distance(b.position);
    if (d_a >= 0) inside.push_back(a);
    if (d_a >= 0 && !(d_b >= 0)) inside.push_back(cut(a, d_a, b, d_b));
    if (!(d_a >= 0) && d_b >= 0) inside.push_back(cut(b, d_b, a, d_a));
  }
  return inside;
}

}  // namespace
// </solution>

ClipPolygon clip_drop(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  // <solution>
  for (const Eigen::Vector4f& corner : triangle) {
    if (!(distance_to_near(corner) >= 0)) return {};
  }
  return whole(triangle);
  // <starter> throw NotWritten("04.9", triangle, guard);
  // </solution>
}

ClipPolygon clip_near(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  // <solution>
  const ClipPolygon polygon = whole(triangle);
  ClipPolygon inside;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipVertex& a = polygon[i];
    const ClipVertex& b = polygon[(i + 1) % 3];
    const float d_a = distance_to_near(a.position);
    const float d_b = distance_to_near(b.position);
    if (d_a >= 0) inside.push_back(a);
    if ((d_a >= 0) != (d_b >= 0)) inside.push_back(cut(a, d_a, b, d_b));
  }
  return inside;
  // <starter> throw NotWritten("04.9", triangle, guard);
  // </solution>
}

ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard) {
  // <solution>
  using Point = Eigen::Vector4d;
  std::vector<WideVertex> polygon;
  for (const ClipVertex& corner : whole(triangle)) {
    polygon.push_back({corner.position.cast<double>(), corner.weights.cast<double>()});
  }
  const double guard_x = guard.x();
  const double guard_y = guard.y();
  polygon = clip_at(polygon, distance_to_near<Point>);
  polygon = clip_at(polygon, [&](const Point& p) { return guard_x * p.w() + p.x(); });
  polygon = clip_at(polygon, [&](const Point& p) { return guard_x * p.w() - p.x(); });
  polygon = clip_at(polygon, [&](const Point& p) { return guard_y * p.w() + p.y(); });
  polygon = clip_at(polygon, [&](const Point& p) { return guard_y * p.w() - p.y(); });
  ClipPolygon rounded;
  for (const WideVertex& vertex : polygon) {
    rounded.push_back({vertex.position.cast<float>(), vertex.weights.cast<float>()});
  }
  return rounded;
  // <starter> throw NotWritten("04.9", triangle, guard);
  // </solution>
}

}  // namespace rasterlab

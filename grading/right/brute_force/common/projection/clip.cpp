// A right answer written differently: distances of all corners first, then one plane after the
// other from a list.
#include "common/projection/clip.h"

#include "common/image/check.h"

namespace rasterlab {
namespace {

struct Plane {
  int axis;     ///< 0 x, 1 y, 2 z
  float sign;   ///< of the coordinate
  float guard;  ///< of w
};

float distance(const Plane& plane, const Eigen::Vector4f& p) {
  return plane.guard * p.w() + plane.sign * p[plane.axis];
}

ClipVertex mix(const ClipVertex& a, const ClipVertex& b, float t) {
  return ClipVertex{Eigen::Vector4f(a.position + t * (b.position - a.position)),
                    Eigen::Vector3f(a.weights + t * (b.weights - a.weights))};
}

ClipPolygon clip_by(const ClipPolygon& polygon, const Plane& plane, bool from_the_inside) {
  std::vector<float> distances;
  for (const ClipVertex& vertex : polygon) distances.push_back(distance(plane, vertex.position));
  ClipPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    const bool in = distances[i] >= 0, next_in = distances[j] >= 0;
    if (in) result.push_back(polygon[i]);
    if (in == next_in) continue;
    const std::size_t from = !in && from_the_inside ? j : i, to = from == i ? j : i;
    result.push_back(
        mix(polygon[from], polygon[to], distances[from] / (distances[from] - distances[to])));
  }
  return result;
}

ClipPolygon uncut(const ClipTriangle& triangle) {
  ClipPolygon polygon(3);
  for (std::size_t i = 0; i < 3; ++i) {
    polygon[i].position = triangle[i];
    polygon[i].weights.setZero();
    polygon[i].weights[Eigen::Index(i)] = 1;
  }
  return polygon;
}

constexpr Plane near_plane = {2, 1, 1};

}  // namespace

ClipPolygon clip_drop(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  int in_front = 0;
  for (const Eigen::Vector4f& corner : triangle)
    in_front += distance(near_plane, corner) >= 0 ? 1 : 0;
  if (in_front < 3) return {};
  return uncut(triangle);
}

ClipPolygon clip_near(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  return clip_by(uncut(triangle), near_plane, false);
}

ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard) {
  ClipPolygon polygon = uncut(triangle);
  for (const Plane& plane : {near_plane, Plane{0, 1, guard.x()}, Plane{0, -1, guard.x()},
                             Plane{1, 1, guard.y()}, Plane{1, -1, guard.y()}}) {
    polygon = clip_by(polygon, plane, true);
  }
  return polygon;
}

}  // namespace rasterlab

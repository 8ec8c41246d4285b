// A right answer written differently: distances of all corners first, then one plane after the
// other from a list; a corner is seven numbers.
#include "common/projection/clip.h"

#include "common/image/check.h"

namespace rasterlab {
namespace {

struct Plane {
  int axis;     ///< 0 x, 1 y, 2 z
  float sign;   ///< of the coordinate
  float guard;  ///< of w
};

// A position, then weights.
template <class Number>
using Corner = Eigen::Matrix<Number, 7, 1>;
template <class Number>
using Corners = std::vector<Corner<Number>>;

template <class Number>
Number distance(const Plane& plane, const Corner<Number>& p) {
  return Number(plane.guard) * p[3] + Number(plane.sign) * p[plane.axis];
}

template <class Number>
Corners<Number> clip_by(const Corners<Number>& polygon, const Plane& plane, bool from_the_inside) {
  std::vector<Number> distances;
  for (const Corner<Number>& corner : polygon) distances.push_back(distance(plane, corner));
  Corners<Number> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    const bool in = distances[i] >= 0, next_in = distances[j] >= 0;
    if (in) result.push_back(polygon[i]);
    if (in == next_in) continue;
    const std::size_t from = !in && from_the_inside ? j : i, to = from == i ? j : i;
    const Number t = distances[from] / (distances[from] - distances[to]);
    result.push_back(polygon[from] + t * (polygon[to] - polygon[from]));
  }
  return result;
}

template <class Number>
Corners<Number> uncut(const ClipTriangle& triangle) {
  Corners<Number> corners(3);
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i].setZero();
    corners[i].template head<4>() = triangle[i].cast<Number>();
    corners[i][4 + Eigen::Index(i)] = 1;
  }
  return corners;
}

template <class Number>
ClipPolygon rounded(const Corners<Number>& corners) {
  ClipPolygon polygon;
  for (const Corner<Number>& corner : corners) {
    polygon.push_back({corner.template head<4>().template cast<float>(),
                       corner.template tail<3>().template cast<float>()});
  }
  return polygon;
}

constexpr Plane near_plane = {2, 1, 1};

}  // namespace

ClipPolygon clip_drop(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  int in_front = 0;
  const Corners<float> corners = uncut<float>(triangle);
  for (const Corner<float>& corner : corners) in_front += distance(near_plane, corner) >= 0 ? 1 : 0;
  if (in_front < 3) return {};
  return rounded(corners);
}

ClipPolygon clip_near(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  return rounded(clip_by(uncut<float>(triangle), near_plane, false));
}

ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard) {
  Corners<double> polygon = uncut<double>(triangle);
  for (const Plane& plane : {near_plane, Plane{0, 1, guard.x()}, Plane{0, -1, guard.x()},
                             Plane{1, 1, guard.y()}, Plane{1, -1, guard.y()}}) {
    polygon = clip_by(polygon, plane, true);
  }
  return rounded(polygon);
}

}  // namespace rasterlab

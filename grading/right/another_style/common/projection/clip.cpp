// A right answer written differently: each plane a row of numbers; the near cut a case for each
// corner.
#include "common/projection/clip.h"

#include "common/image/check.h"

namespace rasterlab {
namespace {

float beyond_near(const Eigen::Vector4f& p) {
  return p.z() + p.w();
}

ClipPolygon all_of(const ClipTriangle& triangle) {
  ClipPolygon polygon;
  for (int i = 0; i < 3; ++i) {
    polygon.push_back({triangle[static_cast<std::size_t>(i)], Eigen::Vector3f::Unit(i)});
  }
  return polygon;
}

ClipVertex between(const ClipVertex& from, const ClipVertex& to, float d_from, float d_to) {
  const float t = d_from / (d_from - d_to);
  return {from.position + t * (to.position - from.position),
          from.weights + t * (to.weights - from.weights)};
}

}  // namespace

ClipPolygon clip_drop(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  const bool seen = beyond_near(triangle[0]) >= 0 && beyond_near(triangle[1]) >= 0 &&
                    beyond_near(triangle[2]) >= 0;
  return seen ? all_of(triangle) : ClipPolygon{};
}

ClipPolygon clip_near(const ClipTriangle& triangle, [[maybe_unused]] const Eigen::Vector2f& guard) {
  const ClipPolygon corners = all_of(triangle);
  ClipPolygon left;
  std::size_t from = 0;
  for (const std::size_t to : {1, 2, 0}) {
    const float d_from = beyond_near(corners[from].position),
                d_to = beyond_near(corners[to].position);
    if (d_from >= 0) left.push_back(corners[from]);
    if ((d_from >= 0) != (d_to >= 0))
      left.push_back(between(corners[from], corners[to], d_from, d_to));
    from = to;
  }
  return left;
}

ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard) {
  ClipPolygon polygon = all_of(triangle);
  for (int plane = 0; plane < 5; ++plane) {
    const auto distance = [&](const ClipVertex& vertex) {
      const Eigen::Vector4f& p = vertex.position;
      switch (plane) {
        case 0:
          return beyond_near(p);
        case 1:
          return guard.x() * p.w() + p.x();
        case 2:
          return guard.x() * p.w() - p.x();
        case 3:
          return guard.y() * p.w() + p.y();
        default:
          return guard.y() * p.w() - p.y();
      }
    };
    ClipPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ClipVertex &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
      const float d_here = distance(here), d_next = distance(next);
      const bool is_in = d_here >= 0, next_is_in = d_next >= 0;
      if (is_in) kept.push_back(here);
      if (is_in && !next_is_in) kept.push_back(between(here, next, d_here, d_next));
      if (!is_in && next_is_in) kept.push_back(between(next, here, d_next, d_here));
    }
    polygon = kept;
  }
  return polygon;
}

}  // namespace rasterlab

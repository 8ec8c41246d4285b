// A right answer written differently: each plane a row of numbers; the near cut a case for each
// corner.
#include "common/projection/clip.h"

#include "common/image/check.h"

namespace rasterlab {
namespace {

float beyond_near(const Eigen::Vector4f& p) {
  return p.z() + p.w();
}

// x, y, z, w and the three weights in one row, in double precision.
using Row = Eigen::Matrix<double, 1, 7>;

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
  std::vector<Row> polygon;
  for (const ClipVertex& corner : all_of(triangle)) {
    polygon.emplace_back();
    polygon.back() << corner.position.transpose().cast<double>(),
        corner.weights.transpose().cast<double>();
  }
  for (int plane = 0; plane < 5; ++plane) {
    const auto distance = [&](const Row& p) {
      switch (plane) {
        case 0:
          return p[2] + p[3];
        case 1:
          return double(guard.x()) * p[3] + p[0];
        case 2:
          return double(guard.x()) * p[3] - p[0];
        case 3:
          return double(guard.y()) * p[3] + p[1];
        default:
          return double(guard.y()) * p[3] - p[1];
      }
    };
    std::vector<Row> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Row &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
      const double d_here = distance(here), d_next = distance(next);
      const bool is_in = d_here >= 0, next_is_in = d_next >= 0;
      if (is_in) kept.push_back(here);
      if (is_in && !next_is_in) kept.push_back(here + d_here / (d_here - d_next) * (next - here));
      if (!is_in && next_is_in) kept.push_back(next + d_next / (d_next - d_here) * (here - next));
    }
    polygon = kept;
  }
  ClipPolygon left;
  for (const Row& row : polygon) {
    left.push_back(
        {row.head<4>().transpose().cast<float>(), row.tail<3>().transpose().cast<float>()});
  }
  return left;
}

}  // namespace rasterlab

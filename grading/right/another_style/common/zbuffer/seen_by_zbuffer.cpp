// A right answer written differently: all depths that a pixel is covered with are kept, and the
// best is chosen at the end.
#include "common/image/check.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rasterlab {
namespace {

struct Covering {
  std::int32_t triangle;
  float depth;
};

template <class DepthOf, class Round>
VisibleTriangles best(const VisibilityScene& scene, DepthOf depth_of, Round round, float sign) {
  std::vector<std::vector<Covering>> all(std::size_t(scene.width) * std::size_t(scene.height));
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const VisibilityTriangle& triangle = scene.triangles[i];
    const Eigen::Vector3d corners(depth_of(triangle.distances[0]), depth_of(triangle.distances[1]),
                                  depth_of(triangle.distances[2]));
    rasterize_triangle(triangle.corners, scene.width, scene.height,
                       [&](int x, int y, const Eigen::Vector3d& weights) {
                         const std::size_t pixel =
                             std::size_t(y) * std::size_t(scene.width) + std::size_t(x);
                         all[pixel].push_back({std::int32_t(i), round(corners.dot(weights))});
                       });
  }
  VisibleTriangles seen(scene.width, scene.height, -1);
  for (std::size_t pixel = 0; pixel < all.size(); ++pixel) {
    const auto first = std::min_element(
        all[pixel].begin(), all[pixel].end(),
        [sign](const Covering& a, const Covering& b) { return sign * a.depth < sign * b.depth; });
    if (first != all[pixel].end()) seen.pixels()[pixel] = first->triangle;
  }
  return seen;
}

auto from_near_to_far(const VisibilityScene& scene) {
  return [scale = scene.far / (scene.far - scene.near), near = scene.near](float distance) {
    return scale * (1 - near / distance);
  };
}

float as_float(double depth) {
  return static_cast<float>(depth);
}

}  // namespace

VisibleTriangles seen_by_zbuffer_16(const VisibilityScene& scene) {
  const auto code = [](double depth) { return static_cast<float>(std::rint(depth * 0xFFFF)); };
  return best(scene, from_near_to_far(scene), code, 1);
}

VisibleTriangles seen_by_zbuffer_24(const VisibilityScene& scene) {
  const auto code = [](double depth) { return static_cast<float>(std::rint(depth * 0xFFFFFF)); };
  return best(scene, from_near_to_far(scene), code, 1);
}

VisibleTriangles seen_by_zbuffer_float(const VisibilityScene& scene) {
  return best(scene, from_near_to_far(scene), as_float, 1);
}

VisibleTriangles seen_by_zbuffer_reversed(const VisibilityScene& scene) {
  const auto inverse = [&scene](float distance) { return scene.near / distance; };
  return best(scene, inverse, as_float, -1);
}

}  // namespace rasterlab

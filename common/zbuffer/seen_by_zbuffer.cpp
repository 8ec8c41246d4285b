#include "common/image/check.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include <cmath>

namespace rasterlab {
// <solution>
namespace {

/// Draws with a depth buffer. `stored(depth)` is what the buffer's format makes of a depth in [0,
/// 1], `is_nearer(a, b)` compares two of those; `depth_of(distance)` must be linear in 1/distance.
template <class DepthOf, class Stored, class IsNearer>
VisibleTriangles draw(const VisibilityScene& scene, DepthOf depth_of, Stored stored, float farthest,
                      IsNearer is_nearer) {
  VisibleTriangles seen(scene.width, scene.height, -1);
  Image<float> buffer(scene.width, scene.height, farthest);
  for (std::size_t index = 0; index < scene.triangles.size(); ++index) {
    const VisibilityTriangle& triangle = scene.triangles[index];
    Eigen::Vector3f depths;
    for (Eigen::Index i = 0; i < 3; ++i)
      depths[i] = depth_of(triangle.distances[static_cast<std::size_t>(i)]);
    rasterize_triangle(triangle.corners, scene.width, scene.height,
                       [&](int x, int y, const Eigen::Vector3d& weights) {
                         const float depth = stored(weights.dot(depths.cast<double>()));
                         if (seen(x, y) >= 0 && !is_nearer(depth, buffer(x, y))) return;
                         buffer(x, y) = depth;
                         seen(x, y) = static_cast<std::int32_t>(index);
                       });
  }
  return seen;
}

/// 0 at the near plane, 1 at the far one.
auto standard_depth(const VisibilityScene& scene) {
  return [near = scene.near, scale = scene.far / (scene.far - scene.near)](float distance) {
    return scale * (1 - near / distance);
  };
}

/// The nearest of the 2^bits codes; exact in a float to 24 bits.
auto unorm(int bits) {
  return [largest = std::ldexp(1.0, bits) - 1](double depth) {
    return static_cast<float>(std::nearbyint(depth * largest));
  };
}

float to_float(double depth) {
  return static_cast<float>(depth);
}

constexpr auto less = [](float a, float b) { return a < b; };
constexpr auto greater = [](float a, float b) { return a > b; };

}  // namespace
// </solution>

VisibleTriangles seen_by_zbuffer_16(const VisibilityScene& scene) {
  // <solution>
  return draw(scene, standard_depth(scene), unorm(16), 0xFFFF, less);
  // <starter> throw NotWritten("03.5", scene);
  // </solution>
}

VisibleTriangles seen_by_zbuffer_24(const VisibilityScene& scene) {
  // <solution>
  return draw(scene, standard_depth(scene), unorm(24), 0xFFFFFF, less);
  // <starter> throw NotWritten("03.5", scene);
  // </solution>
}

VisibleTriangles seen_by_zbuffer_float(const VisibilityScene& scene) {
  // <solution>
  return draw(scene, standard_depth(scene), to_float, 1, less);
  // <starter> throw NotWritten("03.5", scene);
  // </solution>
}

VisibleTriangles seen_by_zbuffer_reversed(const VisibilityScene& scene) {
  // <solution>
  const auto reversed_depth = [near = scene.near](float distance) { return near / distance; };
  return draw(scene, reversed_depth, to_float, 0, greater);
  // <starter> throw NotWritten("03.5", scene);
  // </solution>
}

}  // namespace rasterlab

#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include <algorithm>
#include <numeric>

namespace rasterlab {
namespace {

/// Paints the triangles over each other in the given order.
VisibleTriangles paint(const VisibilityScene& scene, const std::vector<std::int32_t>& order) {
  VisibleTriangles seen(scene.width, scene.height, -1);
  for (const std::int32_t index : order) {
    rasterize_triangle(scene.triangles[static_cast<std::size_t>(index)].corners, scene.width,
                       scene.height,
                       [&](int x, int y, const Eigen::Vector3d&) { seen(x, y) = index; });
  }
  return seen;
}

std::vector<std::int32_t> draw_order(const VisibilityScene& scene) {
  std::vector<std::int32_t> order(scene.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

}  // namespace

VisibleTriangles seen_by_draw_order(const VisibilityScene& scene) {
  return paint(scene, draw_order(scene));
}

VisibleTriangles seen_by_painter(const VisibilityScene& scene) {
  const auto mean_distance = [&](std::int32_t index) {
    const auto& [a, b, c] = scene.triangles[static_cast<std::size_t>(index)].distances;
    return (double{a} + b + c) / 3;
  };
  std::vector<std::int32_t> order = draw_order(scene);
  std::reverse(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return mean_distance(a) > mean_distance(b);
  });
  return paint(scene, order);
}

}  // namespace rasterlab

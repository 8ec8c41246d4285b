#include "bench/engine/exact_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rasterlab::bench {

namespace {

/// In 1/256 pixel.
struct WindowPoint {
  std::int64_t x, y;
};

WindowPoint project(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& p, int width,
                    int height) {
  const auto row = [&](Eigen::Index r) {
    long double sum = matrix(r, 3);
    for (Eigen::Index i = 0; i < 3; ++i) sum += static_cast<long double>(matrix(r, i)) * p[i];
    return sum;
  };
  const long double w = row(3);
  if (!(w > 0)) throw std::runtime_error("exact coverage of what reaches behind the eye");
  return {std::llrint((row(0) / w + 1) * width * 128),
          std::llrint((1 - row(1) / w) * height * 128)};
}

/// Positive on the inner side.
struct Edge {
  std::int64_t step_x, step_y, at_origin;

  Edge(WindowPoint a, WindowPoint b)
      : step_x(a.y - b.y), step_y(b.x - a.x), at_origin(-step_x * a.x - step_y * a.y) {
    const bool is_top_left = step_x > 0 || (step_x == 0 && step_y > 0);
    if (!is_top_left) --at_origin;  // then 0 is outside
  }

  /// Narrows [first, last] to the pixels of row y that are inside.
  void narrow(std::int64_t y, std::int64_t& first, std::int64_t& last) const {
    const std::int64_t at_0 = at_origin + step_x * 128 + step_y * (256 * y + 128);
    const auto divided_down = [](std::int64_t a, std::int64_t b) {
      return a >= 0 ? a / b : -((-a + b - 1) / b);
    };
    if (step_x > 0) {
      first = std::max(first, -divided_down(at_0, 256 * step_x));
    } else if (step_x < 0) {
      last = std::min(last, divided_down(at_0, -256 * step_x));
    } else if (at_0 < 0) {
      last = first - 1;
    }
  }
};

void fill(std::array<WindowPoint, 3> p, Image<std::uint8_t>& image) {
  const std::int64_t area =
      (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  if (area == 0) return;
  if (area < 0) std::swap(p[1], p[2]);
  const std::array<Edge, 3> edges = {Edge(p[0], p[1]), Edge(p[1], p[2]), Edge(p[2], p[0])};
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const std::int64_t last_row = std::min<std::int64_t>(bottom >> 8, image.height() - 1);
  for (std::int64_t y = std::max<std::int64_t>(top >> 8, 0); y <= last_row; ++y) {
    std::int64_t first = 0;
    std::int64_t last = image.width() - 1;
    for (const Edge& edge : edges) edge.narrow(y, first, last);
    if (first > last) continue;
    std::uint8_t* row = image.row(static_cast<int>(y));
    std::fill(row + first, row + last + 1, std::uint8_t{255});
  }
}

}  // namespace

Image<std::uint8_t> exact_coverage(const Scene& scene, int width, int height) {
  std::vector<WindowPoint> window;
  for (const Eigen::Vector3f& p : scene.mesh.positions) {
    window.push_back(project(scene.matrix, p, width, height));
  }
  Image<std::uint8_t> image(width, height, 0);
  for (const auto& [a, b, c] : scene.mesh.triangles) fill({window[a], window[b], window[c]}, image);
  return image;
}

}  // namespace rasterlab::bench

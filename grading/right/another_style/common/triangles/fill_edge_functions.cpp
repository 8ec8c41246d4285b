// A right answer written differently: in every row each edge leaves a half of it, whose end is a
// division rounded up or down.
#include "common/triangles/fill_edge_functions.h"

#include "common/triangles/edge_function.h"

#include <algorithm>
#include <cstdint>

namespace rasterlab {
namespace {

std::int64_t rounded_down(std::int64_t a, std::int64_t b) {  // b > 0
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

}  // namespace

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const TriangleEdges triangle = make_edges(snap(corners));
  if (triangle.twice_area == 0) return;
  for (int y = 0; y < image.height(); ++y) {
    std::int64_t left = 0, right = image.width() - 1;
    for (const EdgeFunction& edge : triangle.edges) {
      // edge.at(0, y) + x · step ≥ threshold
      const std::int64_t needed = edge.threshold() - edge.at(0, y), step = edge.step_x;
      if (step > 0) left = std::max(left, -rounded_down(-needed, step));
      if (step < 0) right = std::min(right, rounded_down(-needed, -step));
      if (step == 0 && needed > 0) right = -1;
    }
    for (std::int64_t x = left; x <= right; ++x) image(static_cast<int>(x), y) = color;
  }
}

}  // namespace rasterlab

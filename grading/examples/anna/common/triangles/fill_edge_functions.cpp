#include "common/triangles/fill_edge_functions.h"

#include <utility>

namespace rasterlab {
namespace {

std::int64_t area(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// 1 where a centre on the edge is outside, so that it is one short of 0
int shortfall(const SnappedPoint& from, const SnappedPoint& to) {
  const bool left = to.y() < from.y();
  const bool top = to.y() == from.y() && from.x() < to.x();
  return left || top ? 0 : 1;
}

}  // namespace

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  auto [a, b, c] = snap(corners);
  if (area(a, b, c) < 0) std::swap(b, c);  // now clockwise on the screen
  if (area(a, b, c) == 0) return;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const SnappedPoint center(256 * x + 128, 256 * y + 128);
      if (area(a, b, center) >= shortfall(a, b) && area(b, c, center) >= shortfall(b, c) &&
          area(c, a, center) >= shortfall(c, a)) {
        image(x, y) = color;
      }
    }
  }
}

}  // namespace rasterlab

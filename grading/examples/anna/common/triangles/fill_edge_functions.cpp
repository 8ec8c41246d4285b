#include "common/triangles/fill_edge_functions.h"

#include <cstdint>

namespace rasterlab {
namespace {

int sign_of_side(const SnappedPoint& a, const SnappedPoint& b, std::int64_t x, std::int64_t y) {
  const std::int64_t dx = b.x() - a.x(), dy = b.y() - a.y();
  const std::int64_t value = dx * (y - a.y()) - dy * (x - a.x());
  if (value != 0) return value > 0 ? 1 : -1;
  if (dy != 0) return dy > 0 ? -1 : 1;  // a step to the right
  return dx > 0 ? 1 : dx < 0 ? -1 : 0;  // and one down
}

}  // namespace

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const SnappedTriangle p = snap(corners);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::int64_t cx = 256 * x + 128, cy = 256 * y + 128;
      const int side = sign_of_side(p[0], p[1], cx, cy);
      if (side != 0 && side == sign_of_side(p[1], p[2], cx, cy) &&
          side == sign_of_side(p[2], p[0], cx, cy))
        image(x, y) = color;
    }
  }
}

}  // namespace rasterlab

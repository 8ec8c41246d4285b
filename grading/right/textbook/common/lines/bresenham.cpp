// A right answer written differently: one error for both axes, as in A. Zingl's version, from p0
// whatever the octant.
#include "common/lines/bresenham.h"

#include <cstdint>
#include <cstdlib>

namespace rasterlab {

LineDiscrete line_bresenham(const Point& p0, const Point& p1) {
  const std::int64_t dx = std::abs(std::int64_t{p1.x()} - p0.x());
  const std::int64_t dy = -std::abs(std::int64_t{p1.y()} - p0.y());
  const int step_x = p0.x() < p1.x() ? 1 : -1;
  const int step_y = p0.y() < p1.y() ? 1 : -1;
  std::int64_t error = dx + dy;
  Point pixel = p0;
  LineDiscrete line;
  line.append(pixel);
  while (pixel != p1) {
    const std::int64_t twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      pixel.x() += step_x;
    }
    if (twice <= dx) {
      error += dx;
      pixel.y() += step_y;
    }
    line.append(pixel);
  }
  return line;
}

}  // namespace rasterlab

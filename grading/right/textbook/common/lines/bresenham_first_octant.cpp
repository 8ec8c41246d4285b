// A right answer written differently: an error that starts at 0 and is compared with half a pixel.
#include "common/lines/bresenham_first_octant.h"

#include "common/image/check.h"

#include <algorithm>
#include <cstdint>

namespace rasterlab {

LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  if (!(0 <= dy && dy <= dx)) throw CheckError("not in the first octant");
  LineDiscrete line;
  std::int64_t error = 0;
  Point pixel = p0;
  for (std::int64_t k = 0; k <= std::min(dx, steps.last); ++k) {
    if (k >= steps.first) line.append(pixel);
    pixel.x() += 1;
    error += dy;
    if (2 * error >= dx) {
      error -= dx;
      pixel.y() += 1;
    }
  }
  return line;
}

}  // namespace rasterlab

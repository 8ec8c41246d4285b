// A right answer written differently: the textbook's decision variable, half rounded down.
#include "common/lines/bresenham_first_octant.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps) {
  const std::int64_t dx = p1.x() - std::int64_t{p0.x()};
  const std::int64_t dy = p1.y() - std::int64_t{p0.y()};
  if (dy < 0 || dy > dx) throw CheckError("not in the first octant");
  LineDiscrete out;
  int y = p0.y();
  std::int64_t d = 2 * dy - dx;
  for (std::int64_t i = 0; i <= dx; i++) {
    if (i >= steps.first && i <= steps.last) out.append(Point(int(p0.x() + i), y));
    if (d > 0) {
      y++;
      d -= 2 * dx;
    }
    d += 2 * dy;
  }
  return out;
}

}  // namespace rasterlab

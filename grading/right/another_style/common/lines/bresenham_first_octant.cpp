// A right answer written differently: the textbook's decision variable, half rounded down, from
// 128 bits at the first step.
#include "common/lines/bresenham_first_octant.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps) {
  __extension__ using Wide = __int128;
  const std::int64_t dx = p1.x() - std::int64_t{p0.x()};
  const std::int64_t dy = p1.y() - std::int64_t{p0.y()};
  if (dy < 0 || dy > dx) throw CheckError("not in the first octant");
  const std::int64_t first = std::max<std::int64_t>(0, steps.first);
  const std::int64_t last = std::min(dx, steps.last);
  // d is above 0 where the next pixel is a row below: 2 (k + 1) dy − (2 rows + 1) dx.
  const Wide gone = Wide{2} * first * dy;
  const Wide rows = dx == 0 ? Wide{0} : (gone + dx - 1) / (2 * dx);
  auto d = static_cast<std::int64_t>(gone + 2 * dy - (2 * rows + 1) * dx);
  auto y = static_cast<int>(p0.y() + rows);
  LineDiscrete out;
  for (std::int64_t i = first; i <= last; i++) {
    out.append(Point(int(p0.x() + i), y));
    if (d > 0) {
      y++;
      d -= 2 * dx;
    }
    d += 2 * dy;
  }
  return out;
}

}  // namespace rasterlab

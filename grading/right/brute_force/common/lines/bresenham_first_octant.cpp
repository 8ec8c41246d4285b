// A right answer written differently: each row by a division of its own, no row known from the one
// before.
#include "common/lines/bresenham_first_octant.h"

#include "common/image/check.h"

#include <cstdint>

namespace rasterlab {

LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  if (dy < 0 || dx < dy) throw CheckError("the segment leaves the first octant");
  LineDiscrete line;
  const StepRange wanted = intersection(steps, {0, dx});
  for (std::int64_t k = wanted.first; k <= wanted.last; ++k) {
    const auto twice = static_cast<std::uint64_t>(2 * dx);
    const auto doubled_rows = static_cast<std::uint64_t>(k) * static_cast<std::uint64_t>(2 * dy);
    const std::uint64_t down =
        dx == 0 ? 0 : (doubled_rows + static_cast<std::uint64_t>(dx)) / twice;
    line.append(Point(static_cast<int>(p0.x() + k), p0.y() + static_cast<int>(down)));
  }
  return line;
}

}  // namespace rasterlab

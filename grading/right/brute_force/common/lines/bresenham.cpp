// A right answer written differently: for every step the nearest pixel by a rounded division, from
// the other end, with the other choice where two are equally near.
#include "common/lines/bresenham.h"

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace rasterlab {

LineDiscrete line_bresenham(const Point& p0, const Point& p1) {
  const std::int64_t dx = std::int64_t{p0.x()} - p1.x();
  const std::int64_t dy = std::int64_t{p0.y()} - p1.y();
  const std::int64_t steps = std::max(std::abs(dx), std::abs(dy));
  // ⌈2·a/b − ½⌉-like rounding: half goes down, the reference's goes up.
  const auto nearest = [&](std::int64_t k, std::int64_t d) {
    if (steps == 0) return std::int64_t{0};
    const std::int64_t twice = 2 * k * std::abs(d);
    const std::int64_t rounded = (twice + steps - 1) / (2 * steps);
    return d < 0 ? -rounded : rounded;
  };
  LineDiscrete line;
  for (std::int64_t k = 0; k <= steps; ++k) {
    line.append(
        {static_cast<int>(p1.x() + nearest(k, dx)), static_cast<int>(p1.y() + nearest(k, dy))});
  }
  return line;
}

}  // namespace rasterlab

// A right answer written differently: an error that is compared with half a pixel, known at the
// first step by a division.
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
  const std::int64_t first = std::max<std::int64_t>(steps.first, 0);
  const std::int64_t last = std::min(steps.last, dx);
  if (first > last) return line;

  // In halves of a row: 2 · first · dy + dx fits 64 bits without its sign.
  const std::uint64_t doubled =
      2 * static_cast<std::uint64_t>(first) * static_cast<std::uint64_t>(dy);
  const std::uint64_t rows =
      dx == 0 ? 0 : (doubled + static_cast<std::uint64_t>(dx)) / static_cast<std::uint64_t>(2 * dx);
  std::int64_t error =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(first) * static_cast<std::uint64_t>(dy) -
                                rows * static_cast<std::uint64_t>(dx));
  Point pixel(static_cast<int>(p0.x() + first),
              static_cast<int>(p0.y() + static_cast<std::int64_t>(rows)));
  for (std::int64_t k = first; k <= last; ++k) {
    line.append(pixel);
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

// A right answer written differently: run by run. A run is what the line has in one row, or in one
// column where it is steep; where it ends follows from a division.
#include "common/lines/bresenham.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace rasterlab {

LineDiscrete line_bresenham(const Point& p0, const Point& p1) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x(), dy = std::int64_t{p1.y()} - p0.y();
  const bool steep = std::abs(dy) > std::abs(dx);
  const std::int64_t length = std::max(std::abs(dx), std::abs(dy));
  const std::int64_t runs = std::min(std::abs(dx), std::abs(dy));
  const auto moved = [](int start, std::int64_t by, std::int64_t sense) {
    return static_cast<int>(start + (sense < 0 ? -by : by));
  };
  LineDiscrete line;
  std::int64_t along = 0;
  for (std::int64_t run = 0; run <= runs; ++run) {
    // Up to the step before the ideal segment is half a pixel further than this run.
    const std::int64_t end =
        run == runs ? length : ((2 * run + 1) * length + 2 * runs - 1) / (2 * runs) - 1;
    for (; along <= end; ++along) {
      line.append({moved(p0.x(), steep ? run : along, dx), moved(p0.y(), steep ? along : run, dy)});
    }
  }
  return line;
}

}  // namespace rasterlab

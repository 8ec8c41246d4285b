#include "common/lines/bresenham.h"

#include "common/image/check.h"
#include "common/lines/swapped_columns.h"

#include <cstdint>
#include <cstdlib>

namespace rasterlab {

LineDiscrete line_bresenham(const Point& p0, const Point& p1) {
  // <solution>
  const TurnedSegment segment = turn(p0, p1);
  const auto& [from, to, transposed] = segment;
  const std::int64_t columns = std::int64_t{to.x()} - from.x();
  const std::int64_t rows = std::abs(std::int64_t{to.y()} - from.y());
  const int direction = to.y() < from.y() ? -1 : 1;
  LineDiscrete line;
  int y = from.y();
  std::int64_t error = 0;  // how far the ideal segment is from row y, times 2 · columns
  for (int x = from.x(); x <= to.x(); ++x) {
    line.append(segment.turned_back(x, y));
    error += 2 * rows;
    if (error >= columns) {
      y += direction;
      error -= 2 * columns;
    }
  }
  return line;
  // <starter> throw NotWritten("01.5", p0, p1);
  // </solution>
}

}  // namespace rasterlab

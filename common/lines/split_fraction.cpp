#include "common/lines/split_fraction.h"

#include "common/lines/swapped_columns.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

LineDiscrete line_split_fraction(const Point& p0, const Point& p1) {
  const TurnedSegment segment = turn(p0, p1);
  const auto& [from, to, transposed] = segment;
  const auto columns =
      static_cast<float>(std::max<std::int64_t>(std::int64_t{to.x()} - from.x(), 1));
  const auto rows = static_cast<float>(std::int64_t{to.y()} - from.y());
  const float slope = std::abs(rows / columns);
  const int direction = rows < 0 ? -1 : 1;
  LineDiscrete line;
  int y = from.y();
  float fraction = 0;
  for (int x = from.x(); x <= to.x(); ++x) {
    line.append(segment.turned_back(x, y));
    fraction += slope;
    if (fraction > 0.5F) {
      y += direction;
      fraction -= 1;
    }
  }
  return line;
}

}  // namespace rasterlab

#include "common/lines/hoisted_slope.h"

#include "common/lines/swapped_columns.h"

#include <algorithm>

namespace rasterlab {

LineDiscrete line_hoisted_slope(const Point& p0, const Point& p1) {
  const TurnedSegment segment = turn(p0, p1);
  const auto& [from, to, transposed] = segment;
  const auto columns =
      static_cast<float>(std::max<std::int64_t>(std::int64_t{to.x()} - from.x(), 1));
  const float slope = static_cast<float>(std::int64_t{to.y()} - from.y()) / columns;
  LineDiscrete line;
  auto y = static_cast<float>(from.y());
  for (int x = from.x(); x <= to.x(); ++x) {
    line.append(segment.turned_back(x, static_cast<int>(y)));
    y += slope;
  }
  return line;
}

}  // namespace rasterlab

#include "common/lines/swapped_columns.h"

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace rasterlab {

TurnedSegment turn(const Point& p0, const Point& p1) {
  TurnedSegment segment{.from = p0, .to = p1};
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  if (std::abs(dy) > std::abs(dx)) {
    segment.transposed = true;
    std::swap(segment.from.x(), segment.from.y());
    std::swap(segment.to.x(), segment.to.y());
  }
  if (segment.to.x() < segment.from.x()) std::swap(segment.from, segment.to);
  return segment;
}

LineDiscrete line_swapped_columns(const Point& p0, const Point& p1) {
  const TurnedSegment segment = turn(p0, p1);
  const auto& [from, to, transposed] = segment;
  LineDiscrete line;
  const double columns = static_cast<double>(to.x()) - from.x();
  for (int x = from.x(); x <= to.x(); ++x) {
    const double t = columns > 0 ? (static_cast<double>(x) - from.x()) / columns : 0.0;
    line.append(segment.turned_back(x, static_cast<int>((1 - t) * from.y() + t * to.y())));
  }
  return line;
}

}  // namespace rasterlab

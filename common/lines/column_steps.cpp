#include "common/lines/column_steps.h"

namespace rasterlab {

LineDiscrete line_column_steps(const Point& p0, const Point& p1) {
  LineDiscrete line;
  const double columns = static_cast<double>(p1.x()) - p0.x();
  for (int x = p0.x(); x <= p1.x(); ++x) {
    const double t = columns > 0 ? (static_cast<double>(x) - p0.x()) / columns : 0.0;
    line.append({x, static_cast<int>((1 - t) * p0.y() + t * p1.y())});
  }
  return line;
}

}  // namespace rasterlab

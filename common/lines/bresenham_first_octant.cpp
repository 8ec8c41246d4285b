#include "common/lines/bresenham_first_octant.h"

#include "common/image/check.h"

#include <cstdint>

namespace rasterlab {

LineDiscrete bresenham_first_octant(const Point& p0, const Point& p1, const StepRange& steps) {
  // <solution>
  const std::int64_t columns = std::int64_t{p1.x()} - p0.x();
  const std::int64_t rows = std::int64_t{p1.y()} - p0.y();
  if (rows < 0 || rows > columns) throw CheckError("the segment is not in the first octant");
  const StepRange visited = intersection(steps, {0, columns});
  LineDiscrete line;
  if (visited.empty()) return line;

  // (2 k rows + columns) / (2 columns) is how many rows step k is below p0; `remainder` goes from
  // one to the next.
  const Point start = LineSteps(p0, p1).at(visited.first);
  const auto whole = static_cast<std::uint64_t>(2 * columns);
  const auto step = static_cast<std::uint64_t>(2 * rows);
  std::uint64_t remainder = static_cast<std::uint64_t>(columns);
  if (whole > 0) {
    remainder = (static_cast<std::uint64_t>(visited.first) * step + remainder) % whole;
  }
  int y = start.y();
  for (std::int64_t k = visited.first; k <= visited.last; ++k) {
    line.append({static_cast<int>(p0.x() + k), y});
    remainder += step;
    if (remainder >= whole) {
      remainder -= whole;
      ++y;
    }
  }
  return line;
  // <starter> throw NotWritten("01.6", p0, p1, steps);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: signs and a swap, each read off the octant.
#include "common/lines/octants.h"

#include "common/image/check.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace rasterlab {

int octant_number(const Point& p0, const Point& p1) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  static constexpr int numbers[2][2][2] = {{{1, 2}, {8, 7}}, {{4, 3}, {5, 6}}};
  return numbers[dx < 0][dy < 0][std::abs(dy) > std::abs(dx)];
}

Point symmetry_octant(const Point& point, int octant) {
  if (octant < 1 || octant > 8) throw CheckError("no octant " + std::to_string(octant));
  const Point upright(octant >= 3 && octant <= 6 ? -point.x() : point.x(),
                      octant >= 5 ? -point.y() : point.y());
  return octant % 4 == 2 || octant % 4 == 3 ? Point(upright.y(), upright.x()) : upright;
}

Point symmetry_octant_inverse(const Point& point, int octant) {
  if (octant < 1 || octant > 8) throw CheckError("no octant " + std::to_string(octant));
  Point back = point;
  if (octant % 4 == 2 || octant % 4 == 3) back = Point(point.y(), point.x());
  if (octant >= 3 && octant <= 6) back.x() = -back.x();
  if (octant >= 5) back.y() = -back.y();
  return back;
}

}  // namespace rasterlab

// A right answer written differently: quarter turns until it is in the first quadrant; folded
// octant by octant.
#include "common/lines/octants.h"

#include "common/image/check.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace rasterlab {

int octant_number(const Point& p0, const Point& p1) {
  std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  int octant = 1;
  while (dx < 0 || dy < 0) {
    const std::int64_t turned = -dx;
    dx = dy;
    dy = turned;
    octant += 2;
  }
  return dy > dx ? octant + 1 : octant;
}

Point symmetry_octant(const Point& point, int octant) {
  if (octant < 1 || octant > 8) throw CheckError("octants go from 1 to 8");
  if (octant > 4) return symmetry_octant({point.x(), -point.y()}, 9 - octant);
  if (octant > 2) return symmetry_octant({-point.x(), point.y()}, 5 - octant);
  return octant == 2 ? Point(point.y(), point.x()) : point;
}

Point symmetry_octant_inverse(const Point& point, int octant) {
  if (octant < 1 || octant > 8) throw CheckError("octants go from 1 to 8");
  if (octant == 1) return point;
  if (octant == 2) return {point.y(), point.x()};
  const Point folded = symmetry_octant_inverse(point, octant > 4 ? 9 - octant : 5 - octant);
  return octant > 4 ? Point(folded.x(), -folded.y()) : Point(-folded.x(), folded.y());
}

}  // namespace rasterlab

#include "common/lines/octants.h"

#include "common/image/check.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace rasterlab {

int octant_number(const Point& p0, const Point& p1) {
  // <solution>
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x();
  const std::int64_t dy = std::int64_t{p1.y()} - p0.y();
  const bool steep = std::abs(dy) > std::abs(dx);
  if (dx >= 0 && dy >= 0) return steep ? 2 : 1;
  if (dx < 0 && dy >= 0) return steep ? 3 : 4;
  if (dx < 0) return steep ? 6 : 5;
  return steep ? 7 : 8;
  // <starter> throw NotWritten("01.8", p0, p1);
  // </solution>
}

Point symmetry_octant(const Point& point, int octant) {
  // <solution>
  const int x = point.x();
  const int y = point.y();
  switch (octant) {
    case 1:
      return {x, y};
    case 2:
      return {y, x};
    case 3:
      return {y, -x};
    case 4:
      return {-x, y};
    case 5:
      return {-x, -y};
    case 6:
      return {-y, -x};
    case 7:
      return {-y, x};
    case 8:
      return {x, -y};
    default:
      throw CheckError("octant " + std::to_string(octant) + ": there are octants 1 to 8");
  }
  // <starter> throw NotWritten("01.8", point, octant);
  // </solution>
}

Point symmetry_octant_inverse(const Point& point, int octant) {
  // <solution>
  // A mirror undoes itself; the two that are quarter turns undo each other.
  if (octant == 3) return symmetry_octant(point, 7);
  if (octant == 7) return symmetry_octant(point, 3);
  return symmetry_octant(point, octant);
  // <starter> throw NotWritten("01.8", point, octant);
  // </solution>
}

}  // namespace rasterlab

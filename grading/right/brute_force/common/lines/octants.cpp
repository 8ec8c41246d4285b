// A right answer written differently: the eight symmetries as matrices, and the octant found by
// trying them all.
#include "common/lines/octants.h"

#include "common/image/check.h"

#include <array>
#include <cstdint>
#include <string>

namespace rasterlab {
namespace {

struct Symmetry {
  int xx, xy, yx, yy;
};

const Symmetry& into_first_octant(int octant) {
  static constexpr std::array<Symmetry, 8> symmetries = {{{1, 0, 0, 1},
                                                          {0, 1, 1, 0},
                                                          {0, 1, -1, 0},
                                                          {-1, 0, 0, 1},
                                                          {-1, 0, 0, -1},
                                                          {0, -1, -1, 0},
                                                          {0, -1, 1, 0},
                                                          {1, 0, 0, -1}}};
  if (octant < 1 || octant > 8) throw CheckError("no octant " + std::to_string(octant));
  return symmetries[static_cast<std::size_t>(octant - 1)];
}

}  // namespace

int octant_number(const Point& p0, const Point& p1) {
  const std::int64_t dx = std::int64_t{p1.x()} - p0.x(), dy = std::int64_t{p1.y()} - p0.y();
  for (int octant = 1; octant < 8; ++octant) {
    const Symmetry& m = into_first_octant(octant);
    const std::int64_t x = m.xx * dx + m.xy * dy, y = m.yx * dx + m.yy * dy;
    if (0 <= y && y <= x) return octant;
  }
  return 8;
}

Point symmetry_octant(const Point& point, int octant) {
  const Symmetry& m = into_first_octant(octant);
  return {m.xx * point.x() + m.xy * point.y(), m.yx * point.x() + m.yy * point.y()};
}

Point symmetry_octant_inverse(const Point& point, int octant) {
  const Symmetry& m = into_first_octant(octant);  // orthogonal: its inverse is its transpose
  return {m.xx * point.x() + m.yx * point.y(), m.xy * point.x() + m.yy * point.y()};
}

}  // namespace rasterlab

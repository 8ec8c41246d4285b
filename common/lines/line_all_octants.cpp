#include "common/lines/line_all_octants.h"

#include "common/lines/bresenham_first_octant.h"
#include "common/lines/octants.h"

namespace rasterlab {

LineDiscrete line_all_octants(const Point& p0, const Point& p1, const StepRange& steps) {
  const int octant = octant_number(p0, p1);
  LineDiscrete line;
  for (const Point& pixel :
       bresenham_first_octant(symmetry_octant(p0, octant), symmetry_octant(p1, octant), steps)) {
    line.append(symmetry_octant_inverse(pixel, octant));
  }
  return line;
}

}  // namespace rasterlab

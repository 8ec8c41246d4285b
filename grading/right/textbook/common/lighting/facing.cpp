// A right answer written differently: the determinant by the rule of Sarrus, the three products
// along the diagonals less the three against them.
#include "common/lighting/facing.h"

namespace rasterlab {

Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored) {
  double x[3], y[3], w[3];
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = double(clip[i].x());
    y[i] = double(clip[i].y());
    w[i] = double(clip[i].w());
  }
  const double plus = x[0] * y[1] * w[2] + x[1] * y[2] * w[0] + x[2] * y[0] * w[1];
  const double minus = x[2] * y[1] * w[0] + x[1] * y[0] * w[2] + x[0] * y[2] * w[1];
  if (plus == minus) return Facing::edge_on;
  return (plus > minus) != mirrored ? Facing::front : Facing::back;
}

}  // namespace rasterlab

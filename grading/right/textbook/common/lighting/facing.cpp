// A right answer written differently: the triple product of the corners' (x, y, w).
#include "common/lighting/facing.h"

#include <cmath>

namespace rasterlab {

Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored) {
  const auto seen_from_eye = [&](std::size_t corner) {
    return Eigen::Vector3d(clip[corner].x(), clip[corner].y(), clip[corner].w());
  };
  const double volume = seen_from_eye(0).dot(seen_from_eye(1).cross(seen_from_eye(2)));
  if (volume == 0 || std::isnan(volume)) return Facing::edge_on;
  return std::signbit(volume) == mirrored ? Facing::front : Facing::back;
}

}  // namespace rasterlab

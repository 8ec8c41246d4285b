// A right answer written differently: the determinant as a scalar triple product, its sign flipped
// by name.
#include "common/lighting/facing.h"

namespace rasterlab {
namespace {

Eigen::Vector3d without_z(const Eigen::Vector4f& corner) {
  return {double(corner[0]), double(corner[1]), double(corner[3])};
}

}  // namespace

Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored) {
  const double volume = without_z(clip[0]).dot(without_z(clip[1]).cross(without_z(clip[2])));
  if (volume == 0) return Facing::edge_on;
  const bool counter_clockwise = volume > 0;
  return counter_clockwise != mirrored ? Facing::front : Facing::back;
}

}  // namespace rasterlab

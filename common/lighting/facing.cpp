#include "common/lighting/facing.h"

#include "common/image/check.h"

namespace rasterlab {

Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored) {
  // <solution>
  // In double precision, products of two floats are exact.
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector4f& corner = clip[static_cast<std::size_t>(i)];
    corners.col(i) = Eigen::Vector3f(corner.x(), corner.y(), corner.w()).cast<double>();
  }
  const double side = corners.determinant() * (mirrored ? -1 : 1);
  if (side > 0) return Facing::front;
  return side < 0 ? Facing::back : Facing::edge_on;
  // <starter> throw NotWritten("05.7", clip, mirrored);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: multiplied together: there, divided by the distance, and
// back.
#include "common/projection/central_projection.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {

Eigen::Matrix4f central_projection(float distance) {
  if (!(distance > 0.0F)) throw CheckError("a distance above 0 was expected");
  if (std::isinf(distance)) return Eigen::Matrix4f::Identity();
  Eigen::Matrix4d shear = Eigen::Matrix4d::Identity();
  shear.row(3) -= Eigen::RowVector4d::Unit(2) / static_cast<double>(distance);
  return shear.cast<float>();
}

}  // namespace rasterlab

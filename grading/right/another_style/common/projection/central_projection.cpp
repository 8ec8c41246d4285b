// A right answer written differently: its last row says what w is.
#include "common/projection/central_projection.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix4f central_projection(float distance) {
  if (!(distance > 0)) throw CheckError("the eye must be in front of the plane");
  Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
  m.row(3) = Eigen::RowVector4f(0, 0, -(1 / distance), 1);
  return m;
}

}  // namespace rasterlab

#include "common/triangles/interpolate_attributes.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  // <solution>
  const auto origin = at_corners.col(0);
  return origin + weights[1] * (at_corners.col(1) - origin) +
         weights[2] * (at_corners.col(2) - origin);
  // <starter> throw NotWritten("02.5", at_corners, weights);
  // </solution>
}

}  // namespace rasterlab

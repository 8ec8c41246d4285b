#include "common/triangles/interpolate_attributes.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  return at_corners.col(0) + weights[2] * (at_corners.col(1) - at_corners.col(0)) +
         weights[1] * (at_corners.col(2) - at_corners.col(0));
}

}  // namespace rasterlab

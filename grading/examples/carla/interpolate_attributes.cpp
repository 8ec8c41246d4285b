#include "common/triangles/interpolate_attributes.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  return at_corners * weights.transpose();
}

}  // namespace rasterlab

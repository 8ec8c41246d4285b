// A right answer written differently: the two sides that leave corner 0, as a matrix.
#include "common/triangles/interpolate_attributes.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  Eigen::MatrixX2d sides(at_corners.rows(), 2);
  sides << at_corners.col(1) - at_corners.col(0), at_corners.col(2) - at_corners.col(0);
  return at_corners.col(0) + sides * weights.tail<2>();
}

}  // namespace rasterlab

// A right answer written differently: one attribute after the other.
#include "common/triangles/interpolate_attributes.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  Eigen::VectorXd result(at_corners.rows());
  for (Eigen::Index i = 0; i < at_corners.rows(); ++i) {
    double value = at_corners(i, 0);
    for (int corner = 1; corner < 3; ++corner) {
      value += (at_corners(i, corner) - at_corners(i, 0)) * weights[corner];
    }
    result[i] = value;
  }
  return result;
}

}  // namespace rasterlab

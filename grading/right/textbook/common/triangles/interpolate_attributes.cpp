// A right answer written differently: attribute after attribute.
#include "common/triangles/interpolate_attributes.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights) {
  Eigen::VectorXd result(at_corners.rows());
  for (Eigen::Index i = 0; i < at_corners.rows(); ++i) {
    const double a = at_corners(i, 0), b = at_corners(i, 1), c = at_corners(i, 2);
    result[i] = a + (weights[1] * (b - a) + weights[2] * (c - a));
  }
  return result;
}

}  // namespace rasterlab

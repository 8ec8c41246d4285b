#include "common/projection/normal_matrix.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix3f normal_matrix(const Eigen::Matrix4f& model_view) {
  // <solution>
  // In double precision, where no product of two floats over- or underflows.
  const Eigen::Matrix3d block = model_view.topLeftCorner<3, 3>().cast<double>();
  const Eigen::Vector3d a = block.col(0);
  const Eigen::Vector3d b = block.col(1);
  const Eigen::Vector3d c = block.col(2);
  Eigen::Matrix3d cofactors;
  cofactors << b.cross(c), c.cross(a), a.cross(b);
  const double largest = cofactors.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Eigen::Matrix3f::Zero();
  const double sign = a.dot(cofactors.col(0)) < 0 ? -1 : 1;
  return (cofactors * (sign / largest)).cast<float>();
  // <starter> throw NotWritten("04.10", model_view);
  // </solution>
}

Eigen::Vector3f transform_normal(const Eigen::Matrix3f& normal_matrix,
                                 const Eigen::Vector3f& normal) {
  // <solution>
  return (normal_matrix * normal).stableNormalized();
  // <starter> throw NotWritten("04.10", normal_matrix, normal);
  // </solution>
}

}  // namespace rasterlab

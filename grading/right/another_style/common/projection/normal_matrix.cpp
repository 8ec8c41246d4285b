// A right answer written differently: cofactor by cofactor, from the two other rows and columns.
#include "common/projection/normal_matrix.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix3f normal_matrix(const Eigen::Matrix4f& model_view) {
  const Eigen::Matrix3d m = model_view.topLeftCorner<3, 3>().cast<double>();
  Eigen::Matrix3d cofactors;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      cofactors(i, j) = m(r, c) * m(s, d) - m(r, d) * m(s, c);
    }
  }
  if (m.row(0).dot(cofactors.row(0)) < 0) cofactors = -cofactors;
  const double size = cofactors.cwiseAbs().maxCoeff();
  return size > 0 ? Eigen::Matrix3f((cofactors / size).cast<float>())
                  : Eigen::Matrix3f::Zero().eval();
}

Eigen::Vector3f transform_normal(const Eigen::Matrix3f& normal_matrix,
                                 const Eigen::Vector3f& normal) {
  const Eigen::Vector3d moved = normal_matrix.cast<double>() * normal.cast<double>();
  const double length = moved.stableNorm();
  return length > 0 ? Eigen::Vector3f((moved / length).cast<float>())
                    : Eigen::Vector3f::Zero().eval();
}

}  // namespace rasterlab

// A right answer written differently: each cofactor by itself, from its rows and columns.
#include "common/projection/normal_matrix.h"

namespace rasterlab {

Eigen::Matrix3f normal_matrix(const Eigen::Matrix4f& model_view) {
  Eigen::Matrix3d m = model_view.topLeftCorner<3, 3>().cast<double>();
  Eigen::Matrix3d cofactor;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = (i + 1) % 3;
      const int s = (i + 2) % 3;
      const int p = (j + 1) % 3;
      const int q = (j + 2) % 3;
      cofactor(i, j) = m(r, p) * m(s, q) - m(r, q) * m(s, p);
    }
  }
  const double largest = cofactor.cwiseAbs().maxCoeff();
  if (largest == 0 || largest != largest) return Eigen::Matrix3f::Zero();
  const double determinant = m.row(0).dot(cofactor.row(0));
  return (determinant < 0 ? Eigen::Matrix3d(-cofactor / largest)
                          : Eigen::Matrix3d(cofactor / largest))
      .cast<float>();
}

Eigen::Vector3f transform_normal(const Eigen::Matrix3f& normal_matrix,
                                 const Eigen::Vector3f& normal) {
  const Eigen::Vector3d moved = normal_matrix.cast<double>() * normal.cast<double>();
  const double length = moved.norm();
  if (!(length > 0)) return Eigen::Vector3f::Zero();
  return (moved / length).cast<float>();
}

}  // namespace rasterlab

// A right answer written differently: every cofactor from its own four numbers.
#include "common/projection/normal_matrix.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

Eigen::Matrix3f normal_matrix(const Eigen::Matrix4f& model_view) {
  const Eigen::Matrix4d m = model_view.cast<double>();
  Eigen::Matrix3d cofactors;
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3,
                c2 = (column + 2) % 3;
      cofactors(row, column) = m(r1, c1) * m(r2, c2) - m(r1, c2) * m(r2, c1);
      largest = std::max(largest, std::abs(cofactors(row, column)));
    }
  }
  if (largest == 0) return Eigen::Matrix3f::Zero();
  double determinant = 0;
  for (int column = 0; column < 3; ++column) determinant += m(0, column) * cofactors(0, column);
  cofactors /= determinant < 0 ? -largest : largest;
  return cofactors.cast<float>();
}

Eigen::Vector3f transform_normal(const Eigen::Matrix3f& normal_matrix,
                                 const Eigen::Vector3f& normal) {
  const Eigen::Vector3d moved = normal_matrix.cast<double>() * normal.cast<double>();
  const double length = moved.norm();
  if (length == 0) return Eigen::Vector3f::Zero();
  return (moved / length).cast<float>();
}

}  // namespace rasterlab

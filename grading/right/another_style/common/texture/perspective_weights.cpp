// A right answer written differently: weights relative to the first corner, whose own is what is
// left.
#include "common/texture/perspective_weights.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

Eigen::Vector3d exact_weights(const Eigen::Vector3d& on_screen, const Eigen::Vector3d& inverse_w) {
  Eigen::Array3d parts = on_screen.array() * inverse_w.array();
  const double sum = parts(0) + (parts(1) + parts(2));
  parts /= sum;
  return parts.matrix();
}

void perspective_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  std::transform(
      row.weights.begin(), row.weights.end(), on_triangle.begin(),
      [&row](const Eigen::Vector3d& weights) { return exact_weights(weights, row.inverse_w); });
}

}  // namespace rasterlab

#include "common/texture/perspective_weights.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

Eigen::Vector3d exact_weights(const Eigen::Vector3d& on_screen, const Eigen::Vector3d& inverse_w) {
  // <solution>
  const Eigen::Vector3d over_w = on_screen.cwiseProduct(inverse_w);
  return over_w / over_w.sum();
  // <starter> throw NotWritten("06.3", on_screen, inverse_w);
  // </solution>
}

void perspective_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  std::transform(
      row.weights.begin(), row.weights.end(), on_triangle.begin(),
      [&row](const Eigen::Vector3d& weights) { return exact_weights(weights, row.inverse_w); });
}

}  // namespace rasterlab

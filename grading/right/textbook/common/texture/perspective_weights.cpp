// A right answer written differently: the sum first, then each weight over it.
#include "common/texture/perspective_weights.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

Eigen::Vector3d exact_weights(const Eigen::Vector3d& on_screen, const Eigen::Vector3d& inverse_w) {
  const double sum = on_screen.dot(inverse_w);
  return {on_screen[0] * inverse_w[0] / sum, on_screen[1] * inverse_w[1] / sum,
          on_screen[2] * inverse_w[2] / sum};
}

void perspective_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  std::transform(
      row.weights.begin(), row.weights.end(), on_triangle.begin(),
      [&row](const Eigen::Vector3d& weights) { return exact_weights(weights, row.inverse_w); });
}

}  // namespace rasterlab

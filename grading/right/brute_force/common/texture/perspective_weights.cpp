// A right answer written differently: the inverses of w are undone, and each weight counts by the
// other two's w.
#include "common/texture/perspective_weights.h"

namespace rasterlab {

Eigen::Vector3d exact_weights(const Eigen::Vector3d& on_screen, const Eigen::Vector3d& inverse_w) {
  const double w[] = {1 / inverse_w[0], 1 / inverse_w[1], 1 / inverse_w[2]};
  const double a = on_screen[0] * w[1] * w[2];
  const double b = on_screen[1] * w[2] * w[0];
  const double c = on_screen[2] * w[0] * w[1];
  return {a / (a + b + c), b / (a + b + c), c / (a + b + c)};
}

void perspective_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  for (std::size_t i = 0; i < row.weights.size(); ++i)
    on_triangle[i] = exact_weights(row.weights[i], row.inverse_w);
}

}  // namespace rasterlab

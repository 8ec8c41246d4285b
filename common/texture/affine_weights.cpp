#include "common/texture/perspective_weights.h"

#include <algorithm>

namespace rasterlab {

void affine_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  std::copy(row.weights.begin(), row.weights.end(), on_triangle.begin());
}

}  // namespace rasterlab

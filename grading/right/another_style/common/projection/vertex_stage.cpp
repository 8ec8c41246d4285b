// A right answer written differently: column by column, in the order that the contract asks for.
#include "common/projection/vertex_stage.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Vector4f to_clip(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& position) {
  Eigen::Vector4f sum = matrix.col(0) * position.x();
  sum += matrix.col(1) * position.y();
  sum += matrix.col(2) * position.z();
  sum += matrix.col(3);
  return sum;
}

WindowPoint to_window(const Eigen::Vector4f& clip, int width, int height) {
  const Eigen::Vector3f ndc = clip.head<3>() / clip.w();
  WindowPoint point;
  point.position.x() = (ndc.x() + 1) * (0.5F * static_cast<float>(width));
  point.position.y() = (1 - ndc.y()) * (0.5F * static_cast<float>(height));
  point.depth = ndc.z();
  return point;
}

}  // namespace rasterlab

// A right answer written differently: the sums written out, component by component.
#include "common/projection/vertex_stage.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Vector4f to_clip(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& position) {
  const auto& m = matrix;
  const float x = position.x(), y = position.y(), z = position.z();
  return {((m(0, 0) * x + m(0, 1) * y) + m(0, 2) * z) + m(0, 3),
          ((m(1, 0) * x + m(1, 1) * y) + m(1, 2) * z) + m(1, 3),
          ((m(2, 0) * x + m(2, 1) * y) + m(2, 2) * z) + m(2, 3),
          ((m(3, 0) * x + m(3, 1) * y) + m(3, 2) * z) + m(3, 3)};
}

WindowPoint to_window(const Eigen::Vector4f& clip, int width, int height) {
  const float w = clip.w();
  const float x = (clip.x() / w + 1.0F) * (static_cast<float>(width) / 2.0F);
  const float y = (1.0F - clip.y() / w) * (static_cast<float>(height) / 2.0F);
  return WindowPoint{Eigen::Vector2f(x, y), clip.z() / w};
}

}  // namespace rasterlab

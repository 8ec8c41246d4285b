#include "common/projection/vertex_stage.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Vector4f to_clip(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& position) {
  // <solution>
  Eigen::Vector4f clip;
  for (int row = 0; row < 4; ++row) {
    clip[row] = ((matrix(row, 0) * position.x() + matrix(row, 1) * position.y()) +
                 matrix(row, 2) * position.z()) +
                matrix(row, 3);
  }
  return clip;
  // <starter> throw NotWritten("04.7", matrix, position);
  // </solution>
}

WindowPoint to_window(const Eigen::Vector4f& clip, int width, int height) {
  // <solution>
  const float half_width = static_cast<float>(width) / 2;
  const float half_height = static_cast<float>(height) / 2;
  return {
      .position = {(clip.x() / clip.w() + 1) * half_width, (1 - clip.y() / clip.w()) * half_height},
      .depth = clip.z() / clip.w()};
  // <starter> throw NotWritten("04.7", clip, width, height);
  // </solution>
}

}  // namespace rasterlab

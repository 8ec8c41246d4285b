// A right answer written differently: a running sum for each row.
#include "common/projection/vertex_stage.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Vector4f to_clip(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& position) {
  Eigen::Vector4f clip;
  for (int row = 0; row < 4; ++row) {
    float sum = matrix(row, 0) * position[0];
    for (int column = 1; column < 3; ++column) sum = sum + matrix(row, column) * position[column];
    clip[row] = sum + matrix(row, 3);
  }
  return clip;
}

WindowPoint to_window(const Eigen::Vector4f& clip, int width, int height) {
  float ndc[3];
  for (int i = 0; i < 3; ++i) ndc[i] = clip[i] / clip[3];
  const float half_size[2] = {static_cast<float>(width) / 2, static_cast<float>(height) / 2};
  return {{(ndc[0] + 1) * half_size[0], (1 - ndc[1]) * half_size[1]}, ndc[2]};
}

}  // namespace rasterlab

// A right answer written differently: the images of the axes and of the origin, column by column.
#include "common/projection/viewport.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix4f translation(const Eigen::Vector3f& offset) {
  Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 4; ++i) m(i, i) = 1;
  for (int i = 0; i < 3; ++i) m(i, 3) = offset[i];
  return m;
}

Eigen::Matrix4f scaling(const Eigen::Vector3f& factors) {
  Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 4; ++i) m(i, i) = i < 3 ? factors[i] : 1;
  return m;
}

Eigen::Matrix4f viewport(float x, float y, float width, float height) {
  Eigen::Matrix4f m;
  m.col(0) = Eigen::Vector4f(width / 2, 0, 0, 0);
  m.col(1) = Eigen::Vector4f(0, -height / 2, 0, 0);
  m.col(2) = Eigen::Vector4f::UnitZ();
  m.col(3) = Eigen::Vector4f(x + width / 2, y + height / 2, 0, 1);
  return m;
}

}  // namespace rasterlab

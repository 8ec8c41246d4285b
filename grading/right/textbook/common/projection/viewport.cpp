// A right answer written differently: the entries as textbooks print them.
#include "common/projection/viewport.h"

namespace rasterlab {

Eigen::Matrix4f translation(const Eigen::Vector3f& offset) {
  Eigen::Matrix4f m;
  m << 1, 0, 0, offset.x(),  //
      0, 1, 0, offset.y(),   //
      0, 0, 1, offset.z(),   //
      0, 0, 0, 1;
  return m;
}

Eigen::Matrix4f scaling(const Eigen::Vector3f& factors) {
  Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 3; ++i) m(i, i) = factors[i];
  m(3, 3) = 1;
  return m;
}

Eigen::Matrix4f viewport(float x, float y, float width, float height) {
  Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
  m(0, 0) = width / 2;
  m(0, 3) = x + width / 2;
  m(1, 1) = -height / 2;
  m(1, 3) = y + height / 2;
  return m;
}

}  // namespace rasterlab

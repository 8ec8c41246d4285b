#include "common/projection/viewport.h"

namespace rasterlab {

Eigen::Matrix4f translation(const Eigen::Vector3f& offset) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topRightCorner<3, 1>() = offset;
  return matrix;
}

Eigen::Matrix4f scaling(const Eigen::Vector3f& factors) {
  return factors.homogeneous().asDiagonal();
}

Eigen::Matrix4f viewport(float x, float y, float width, float height) {
  return translation({x, y, 0}) * scaling({width / 2, height / 2, 1}) * translation({1, 1, 0}) *
         scaling({1, -1, 1});
}

}  // namespace rasterlab

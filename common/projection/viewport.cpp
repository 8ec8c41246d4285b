#include "common/projection/viewport.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix4f translation(const Eigen::Vector3f& offset) {
  // <solution>
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topRightCorner<3, 1>() = offset;
  return matrix;
  // <starter> throw NotWritten("04.2", offset);
  // </solution>
}

Eigen::Matrix4f scaling(const Eigen::Vector3f& factors) {
  // <solution>
  return factors.homogeneous().asDiagonal();
  // <starter> throw NotWritten("04.2", factors);
  // </solution>
}

Eigen::Matrix4f viewport(float x, float y, float width, float height) {
  // <solution>
  return translation({x, y, 0}) * scaling({width / 2, height / 2, 1}) * translation({1, 1, 0}) *
         scaling({1, -1, 1});
  // <starter> throw NotWritten("04.2", x, y, width, height);
  // </solution>
}

}  // namespace rasterlab

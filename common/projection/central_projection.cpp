#include "common/projection/central_projection.h"

#include "common/image/check.h"

namespace rasterlab {

Eigen::Matrix4f central_projection(float distance) {
  // <solution>
  if (!(distance > 0)) throw CheckError("the eye's distance must be above 0");
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix(3, 2) = -1 / distance;
  return matrix;
  // <starter> throw NotWritten("04.3", distance);
  // </solution>
}

}  // namespace rasterlab

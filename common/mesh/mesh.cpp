#include "common/mesh/mesh.h"

namespace rasterlab {

Eigen::AlignedBox3f bounding_box(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  return box;
}

}  // namespace rasterlab

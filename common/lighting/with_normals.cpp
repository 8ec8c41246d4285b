#include "common/lighting/with_normals.h"

#include "common/lighting/vertex_normals.h"

namespace rasterlab {

Mesh with_normals(Mesh mesh) {
  if (mesh.normals.empty()) mesh.normals = vertex_normals(mesh);
  return mesh;
}

}  // namespace rasterlab

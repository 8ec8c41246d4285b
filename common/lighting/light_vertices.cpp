#include "common/lighting/light_vertices.h"

#include "common/image/check.h"
#include "common/lighting/surface_lighting.h"

namespace rasterlab {

std::vector<Color> light_vertices(const LitMesh& lit_mesh) {
  // <solution>
  const SurfaceLighting lighting(lit_mesh);
  std::vector<Color> colors;
  colors.reserve(lit_mesh.mesh.positions.size());
  for (std::uint32_t vertex = 0; vertex < lit_mesh.mesh.positions.size(); ++vertex) {
    colors.push_back(lighting.light(lighting.vertex(vertex)));
  }
  return colors;
  // <starter> throw NotWritten("05.4", lit_mesh);
  // </solution>
}

}  // namespace rasterlab

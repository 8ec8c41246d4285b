// A right answer written differently: room for all colours first, then each in its place.
#include "common/lighting/light_vertices.h"

#include "common/lighting/surface_lighting.h"

#include <algorithm>

namespace rasterlab {

std::vector<Color> light_vertices(const LitMesh& lit_mesh) {
  const SurfaceLighting lighting(lit_mesh);
  std::vector<Color> colors(lit_mesh.mesh.positions.size());
  std::uint32_t vertex = 0;
  std::generate(colors.begin(), colors.end(),
                [&] { return lighting.light(lighting.vertex(vertex++)); });
  return colors;
}

}  // namespace rasterlab

// A right answer written differently: from the last vertex to the first, into a list that is as
// long from the start.
#include "common/lighting/light_vertices.h"

#include "common/image/check.h"
#include "common/lighting/surface_lighting.h"

namespace rasterlab {

std::vector<Color> light_vertices(const LitMesh& lit_mesh) {
  const SurfaceLighting lighting(lit_mesh);
  std::vector<Color> colors(lit_mesh.mesh.positions.size(), Color::Zero());
  for (auto left = static_cast<std::uint32_t>(colors.size()); left > 0; --left) {
    const SurfaceSample<float> sample = lighting.vertex(left - 1);
    for (int channel = 0; channel < 3; ++channel)
      colors[left - 1][channel] = lighting.light(sample)[channel];
  }
  return colors;
}

}  // namespace rasterlab

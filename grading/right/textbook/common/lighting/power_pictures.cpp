// A right answer written differently: two meshes, two frames, one after the other.
#include "common/lighting/power_pictures.h"

#include "common/image/check.h"
#include "common/lighting/shading.h"

#include <utility>

namespace rasterlab {

PowerPictures draw_power(const LitMesh& lit_mesh, float power, int width, int height) {
  LitMesh whole = lit_mesh;
  whole.material.shininess = power;
  LitMesh shining = whole;
  shining.material.ambient = 0;
  shining.material.diffuse = 0;
  Frame highlight = make_frame(width, height);
  Frame sum = make_frame(width, height);
  shade_phong(shining, highlight);
  shade_phong(whole, sum);
  return {highlight.color, sum.color};
}

}  // namespace rasterlab

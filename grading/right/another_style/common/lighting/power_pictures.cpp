// A right answer written differently: a light without the parts that are not to be seen.
#include "common/lighting/power_pictures.h"

#include "common/lighting/shading.h"

namespace rasterlab {

PowerPictures draw_power(const LitMesh& lit_mesh, float power, int width, int height) {
  LitMesh shiny = lit_mesh;
  shiny.material.shininess = power;
  Frame sum = make_frame(width, height);
  shade_phong(shiny, sum);
  shiny.material.ambient = shiny.material.diffuse = 0;
  Frame highlight = make_frame(width, height);
  shade_phong(shiny, highlight);
  PowerPictures pictures;
  pictures.sum = sum.color;
  pictures.highlight = highlight.color;
  return pictures;
}

}  // namespace rasterlab

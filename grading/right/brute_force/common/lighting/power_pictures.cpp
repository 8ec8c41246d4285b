// A right answer written differently: no other light than the one that is mirrored.
#include "common/lighting/power_pictures.h"

#include "common/image/check.h"
#include "common/lighting/shading.h"

#include <utility>

namespace rasterlab {

PowerPictures draw_power(const LitMesh& lit_mesh, float power, int width, int height) {
  PowerPictures pictures;
  for (const bool alone : {true, false}) {
    LitMesh lit = lit_mesh;
    lit.material.shininess = power;
    if (alone) lit.material.ambient = lit.material.diffuse = 0.0F;
    Frame frame = make_frame(width, height);
    shade_phong(lit, frame);
    (alone ? pictures.highlight : pictures.sum) = frame.color;
  }
  return pictures;
}

}  // namespace rasterlab

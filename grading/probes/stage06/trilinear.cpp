// Exercise 06.4.
#include "common/texture/trilinear.h"

#include "grading/probes/made_up_texture.h"

#include <cmath>

namespace rasterlab::grading {

void trilinear_scene(SceneInputs& scene, Results& results) {
  const Texture texture(texels(scene));
  const float last = static_cast<float>(texture.level_count() - 1);
  for (std::size_t i = 0; i < std::size(wraps); ++i) {
    std::vector<double> colors;
    for (int k = 0; k < 40; ++k) {
      const Vector2<float> uv{scene.real(-1, 2), scene.real(-1, 2)};
      const float level = k % 4 == 0 ? std::floor(scene.real(0, last + 1)) : scene.real(0, last);
      const Vector3<float> color = trilinear_at(texture, wraps[i], uv, level);
      for (const float channel : color) colors.push_back(double(channel));
    }
    results.numbers(wrap_names[i], colors, 1e-5);
  }
}

}  // namespace rasterlab::grading

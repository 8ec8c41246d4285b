// Exercise 06.1.
#include "common/texture/wrap.h"

#include "grading/probes/made_up_texture.h"

#include <limits>

namespace rasterlab::grading {

void wrap_scene(SceneInputs& scene, Results& results) {
  std::vector<float> coordinates = {0, 1, -1, 2, 0.25F, -0.25F, 1.25F, -1.75F, 3};
  if (!scene.example()) {
    for (int i = 0; i < 60; ++i) coordinates.push_back(scene.real(-4, 5));
  }
  coordinates.push_back(std::numeric_limits<float>::infinity());
  coordinates.push_back(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < std::size(wraps); ++i) {
    std::vector<double> wrapped;
    for (const float coordinate : coordinates)
      wrapped.push_back(double(wrap_coordinate(coordinate, wraps[i])));
    results.numbers(wrap_names[i], wrapped, 1e-6);
  }
}

}  // namespace rasterlab::grading

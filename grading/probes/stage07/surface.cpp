// Exercise 07.2.
#include "common/shaders/surface.h"

#include "grading/probes/made_up_point.h"

namespace rasterlab::grading {

void surface_scene(SceneInputs& scene, Results& results) {
  std::vector<double> colors;
  for (int i = 0; i < 40; ++i) {
    const Color color = scene.color();
    const MadeUpSource source{color, scene.direction(), scene.direction()};
    add(colors, surface_color(MadeUpPoint{}, source, source, source));
  }
  results.numbers("the colours", colors, 1e-6);
}

}  // namespace rasterlab::grading

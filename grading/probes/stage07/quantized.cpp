// Exercise 07.3.
#include "common/shaders/quantized.h"

#include "grading/probes/probe.h"

#include <limits>

namespace rasterlab::grading {

void quantize_scene(SceneInputs& scene, Results& results) {
  for (const int levels : {5, scene.whole(2, 4), scene.whole(6, 9)}) {
    std::vector<double> shades;
    for (const float value : {0.0F, 1.0F, -0.3F, 1.7F})
      shades.push_back(double(quantize(value, levels)));
    shades.push_back(double(quantize(std::numeric_limits<float>::quiet_NaN(), levels)));
    // Between the ends of the bands, where rounding decides nothing.
    const int parts = 8 * levels;
    for (int part = 0; part < parts; ++part) {
      const float value = (static_cast<float>(part) + 0.5F) / static_cast<float>(parts);
      shades.push_back(double(quantize(value, levels)));
    }
    results.numbers("in " + std::to_string(levels) + " levels", shades, 1e-6);
  }
}

}  // namespace rasterlab::grading

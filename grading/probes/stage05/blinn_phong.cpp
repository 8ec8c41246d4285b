// Exercise 05.3.
#include "common/lighting/blinn_phong.h"

#include "grading/probes/reflection_scene.h"

namespace rasterlab::grading {

void blinn_phong_scene(SceneInputs& scene, Results& results) {
  reflection_scene(scene, results, &blinn_phong<float>);
}

}  // namespace rasterlab::grading

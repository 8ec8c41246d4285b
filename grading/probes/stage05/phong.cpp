// Exercise 05.2.
#include "common/lighting/phong.h"

#include "grading/probes/reflection_scene.h"

namespace rasterlab::grading {

void phong_scene(SceneInputs& scene, Results& results) {
  reflection_scene(scene, results, &phong<float>);
}

}  // namespace rasterlab::grading

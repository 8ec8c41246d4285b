// Exercise 07.4.
#include "common/shaders/normal_maps.h"

#include "grading/probes/made_up_point.h"

namespace rasterlab::grading {

void tangent_space_scene(SceneInputs& scene, Results& results) {
  std::vector<double> normals;
  for (int i = 0; i < 40; ++i) {
    const Vector3<float> local = scene.direction();
    Vector3<float> normal = scene.direction();
    normal *= scene.real(0.5F, 1);
    Vector3<float> tangent = scene.direction();
    if (i % 8 == 7) normal = 0.5F * Vector3<float>::UnitZ();  // where parallel means exactly so
    if (i % 8 == 7) tangent = Vector3<float>::UnitZ();
    const float handedness = i % 2 == 0 ? 1.0F : -1.0F;
    add(normals, normal_from_tangent_space(local, normal, tangent, handedness));
  }
  results.numbers("the normals", normals, 2e-5);
}

}  // namespace rasterlab::grading

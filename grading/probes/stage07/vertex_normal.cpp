// Exercise 07.8.
#include "common/shaders/vertex_normal.h"

#include "common/mesh/shapes.h"

#include "grading/probes/made_up_point.h"

namespace rasterlab::grading {

void normal_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("wall:1");
  const VertexNormal source(ShaderInputs{.mesh = mesh});
  std::vector<double> normals;
  for (int i = 0; i < 40; ++i) {
    MadeUpPoint point{};
    const Vector3<float> one = scene.direction();
    point.value.normal = one + scene.real(0, 1) * (scene.direction() - one);
    if (i == 7) point.value.normal = Vector3<float>::Zero();
    add(normals, source.normal_at(point));
  }
  results.numbers("the normals", normals, 1e-6);
}

}  // namespace rasterlab::grading

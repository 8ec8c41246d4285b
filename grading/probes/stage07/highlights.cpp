// Exercise 07.6.
#include "common/shaders/highlights.h"

#include "common/mesh/shapes.h"

#include "grading/probes/lit_scene.h"
#include "grading/probes/made_up_point.h"

namespace rasterlab::grading {

void highlights_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("wall:1");
  const LitMesh lit = lit_mesh(scene, mesh);
  ShaderInputs inputs{.mesh = mesh, .transforms = lit.transforms};
  inputs.light = lit.light;
  inputs.material = lit.material;
  const auto add_model = [&](const std::string& name, const auto& model) {
    std::vector<double> parts;
    for (int i = 0; i < 40; ++i) {
      MadeUpPoint point{};
      point.value.position = scene.vector(-1, 1);
      // Half of the normals are near the direction where highlights are.
      const Vector3<float> to_light = direction_to(inputs.light.position, point.value.position);
      const Vector3<float> to_eye = direction_to(eye_of(inputs.transforms), point.value.position);
      const Vector3<float> normal =
          i % 2 == 0 ? Vector3<float>(scene.direction())
                     : normalized(Vector3<float>(to_light + to_eye + 0.3F * scene.direction()));
      const MadeUpSource normals{{}, normal, {}};
      const Reflection<float> reflection = model.light_at(point, normals);
      parts.insert(parts.end(), {double(reflection.ambient), double(reflection.diffuse),
                                 double(reflection.specular)});
    }
    results.numbers(name + ": ambient, diffuse, specular", parts, 1e-4);
  };
  add_model("Phong", Phong(inputs));
  add_model("Blinn-Phong", BlinnPhong(inputs));
}

}  // namespace rasterlab::grading

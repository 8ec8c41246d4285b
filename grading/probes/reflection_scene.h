// How a reflection is tried, Phong's and Blinn's alike.
#pragma once

#include "common/lighting/reflection.h"
#include "common/projection/scene.h"

#include "grading/probes/probe.h"

#include <vector>

namespace rasterlab::grading {

inline Light make_light(SceneInputs& scene) {
  return {.position = {0, 0, 1, 0},
          .intensity = scene.real(0.5F, 1.5F),
          .ambient_intensity = scene.real(0.5F, 1.5F)};
}

inline Material make_material(SceneInputs& scene) {
  if (scene.example()) return {};
  const float ambient = scene.real(0.1F, 0.3F);
  const float diffuse = scene.real(0.3F, 0.9F);
  const float specular = scene.real(0.3F, 0.9F);
  return {ambient, diffuse, specular, static_cast<float>(2 * scene.whole(1, 12))};
}

template <class Reflect>
void reflection_scene(SceneInputs& scene, Results& results, Reflect reflect) {
  std::vector<double> ambient, diffuse, specular;
  const auto add = [&](const Eigen::Vector3f& n, const Eigen::Vector3f& l, const Eigen::Vector3f& e,
                       const Light& light, const Material& material) {
    const Reflection<float> reflection = reflect(n, l, e, light, material);
    ambient.push_back(double(reflection.ambient));
    diffuse.push_back(double(reflection.diffuse));
    specular.push_back(double(reflection.specular));
  };
  for (int i = 0; i < 60; ++i) {
    const Light light = make_light(scene);
    const Material material = make_material(scene);
    const Eigen::Vector3f n = scene.direction();
    // Half of the lights and eyes are near the normal or its mirror image, where highlights are.
    const Eigen::Vector3f l =
        i % 2 == 0 ? scene.direction() : (n + 0.7F * scene.direction()).normalized();
    const Eigen::Vector3f mirrored = 2 * n.dot(l) * n - l;
    const Eigen::Vector3f e =
        i % 3 == 0 ? scene.direction() : (mirrored + 0.4F * scene.direction()).normalized();
    add(n, l, e, light, material);
    add(-n, l, e, light, material);
  }
  add({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, make_light(scene), make_material(scene));
  add({0, 0, 1}, {0, 0, -1}, {0, 0, -1}, make_light(scene), {0.1F, 0.5F, 0.5F, 0});
  results.numbers("ambient", ambient, 1e-5);
  results.numbers("diffuse", diffuse, 1e-5);
  results.numbers("specular", specular, 2e-4);
}

}  // namespace rasterlab::grading

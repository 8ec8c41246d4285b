// Runs the exercises of stage 05 on made-up meshes, normals, lights and materials.
#include "common/lighting/facing.h"
#include "common/lighting/light_vertices.h"
#include "common/lighting/power_pictures.h"
#include "common/lighting/shading.h"
#include "common/lighting/turned_light.h"
#include "common/lighting/vertex_normals.h"
#include "common/mesh/shapes.h"

#include "grading/probes/lit_scene.h"
#include "grading/probes/reflection_scene.h"

namespace rasterlab::grading {

void phong_scene(SceneInputs& scene, Results& results);        // stage05/phong.cpp
void blinn_phong_scene(SceneInputs& scene, Results& results);  // stage05/blinn_phong.cpp

namespace {

void normals_scene(SceneInputs& scene, Results& results) {
  Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "cube:2");
  for (Eigen::Vector3f& position : mesh.positions) position += scene.vector(-0.1F, 0.1F);
  mesh.positions.emplace_back(5, 5, 5);  // a vertex of no triangle
  mesh.triangles.push_back({0, 0, 1});   // a triangle without area
  std::vector<double> numbers;
  for (const Eigen::Vector3f& normal : vertex_normals(mesh))
    numbers.insert(numbers.end(), {double(normal.x()), double(normal.y()), double(normal.z())});
  results.numbers("the normals", numbers, 1e-5);
}

void light_vertices_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "torus:6");
  std::vector<double> numbers;
  for (const Color& color : light_vertices(lit_mesh(scene, mesh)))
    numbers.insert(numbers.end(), {double(color.x()), double(color.y()), double(color.z())});
  results.numbers("the vertices' colours", numbers, 1e-4);
}

void shading_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "torus:6");
  const LitMesh lit = lit_mesh(scene, mesh);
  const auto add = [&](const std::string& name, ShadeFunction shade) {
    Frame frame = make_frame(72, 60);
    shade(lit, frame);
    results.picture(name, frame.color, 1, 3);
  };
  add("flat", &shade_flat);
  add("Gouraud", &shade_gouraud);
  add("Phong", &shade_phong);
}

void turned_light_scene(SceneInputs& scene, Results& results) {
  std::vector<double> numbers;
  for (int i = 0; i < 12; ++i) {
    Light light = make_light(scene);
    const Eigen::Vector3f position = scene.vector(-3, 3);
    light.position = {position.x(), position.y(), position.z(), static_cast<float>(i % 2)};
    const Eigen::Vector3f center = scene.vector(-1, 1);
    const Eigen::Vector3f direction = scene.direction();
    const Eigen::Vector3f axis = i == 11 ? Eigen::Vector3f::Zero() : direction;
    const Light turned = turned_light(light, center, axis, scene.real(0, 360));
    for (const float number : turned.position) numbers.push_back(double(number));
    numbers.push_back(double(turned.intensity));
    numbers.push_back(double(turned.ambient_intensity));
  }
  results.numbers("the lights: position and intensities", numbers, 2e-5);
}

void power_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("icosphere:1");
  const LitMesh lit = lit_mesh(scene, mesh);
  const float power = scene.example() ? 0 : static_cast<float>(scene.whole(1, 10));
  const PowerPictures pictures = draw_power(lit, power, 60, 50);
  results.picture("the highlight alone", pictures.highlight, 1, 3);
  results.picture("the sum", pictures.sum, 1, 3);
}

void facing_scene(SceneInputs& scene, Results& results) {
  std::vector<double> numbers;
  for (int i = 0; i < 60; ++i) {
    std::array<Eigen::Vector4f, 3> clip;
    for (Eigen::Vector4f& corner : clip) {
      const Eigen::Vector3f xyz = scene.vector(-2, 2);
      corner = {xyz.x(), xyz.y(), xyz.z(), i < 20 ? 1 : scene.real(i < 40 ? 0.1F : -2, 2)};
    }
    if (i % 10 == 9) {
      clip[2] = clip[1];
      // So few bits that no order of products rounds: a repeated corner is edge-on to all.
      for (Eigen::Vector4f& corner : clip) corner = (corner * 8).array().round() / 8;
    }
    numbers.push_back(static_cast<double>(facing(clip, i % 4 == 3)));
  }
  results.numbers("which side is seen: 0 front, 1 back, 2 edge-on", numbers);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"05.1", normals_scene},
                    {"05.2", phong_scene},
                    {"05.3", blinn_phong_scene},
                    {"05.4", light_vertices_scene},
                    {"05.5", shading_scene},
                    {"05.6", turned_light_scene},
                    {"05.7", facing_scene},
                    {"05.8", power_scene}});
}

// Runs the exercises of stage 06 on made-up textures, coordinates, triangles and meshes.
#include "common/mesh/shapes.h"
#include "common/texture/textured_mesh.h"
#include "common/texture/textured_triangle.h"

#include "grading/probes/lit_scene.h"
#include "grading/probes/made_up_texture.h"

namespace rasterlab::grading {

void wrap_scene(SceneInputs& scene, Results& results);       // stage06/wrap.cpp
void trilinear_scene(SceneInputs& scene, Results& results);  // stage06/trilinear.cpp

namespace {

void textured_mesh_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "torus:6");
  const LitMesh lit = lit_mesh(scene, mesh);
  const Texture texture(texels(scene));
  const auto add = [&](const std::string& name, const Sampler& sampler) {
    Frame frame = make_frame(72, 60);
    draw_textured_mesh(lit, sampler, frame);
    results.picture(name, frame.color, 1, 6);
  };
  add("with the nearest texel", {&texture, Filter::nearest, Wrap::repeat});
  add("with the trilinear filter", {&texture, Filter::trilinear, Wrap::repeat});
}

/// Two triangles seen along, from above one corner.
void wall(SceneInputs& scene, const Sampler& sampler, Frame& frame) {
  const float near = scene.example() ? 1 : scene.real(0.7F, 1.2F);
  const float far = scene.example() ? 6 : scene.real(4, 9);
  const Eigen::Vector4f left_below(-near, -near, 0, near), left_above(-near, near, 0, near);
  const Eigen::Vector4f right_below(0.8F * far, -far * 0.3F, 0, far);
  const Eigen::Vector4f right_above(0.8F * far, far * 0.3F, 0, far);
  draw_textured_triangle({left_below, right_below, right_above}, {{{0, 0}, {3, 0}, {3, 2}}},
                         sampler, &perspective_weights, frame);
  draw_textured_triangle({left_below, right_above, left_above}, {{{0, 0}, {3, 2}, {0, 2}}}, sampler,
                         &perspective_weights, frame);
}

void perspective_scene(SceneInputs& scene, Results& results) {
  std::vector<double> weights;
  for (int i = 0; i < 40; ++i) {
    const double b1 = double(scene.real(0, 1));
    const double b2 = (1 - b1) * double(scene.real(0, 1));
    const Eigen::Vector3d inverse_w = scene.vector(0.05F, 2).cast<double>();
    const Eigen::Vector3d on_triangle = exact_weights({1 - b1 - b2, b1, b2}, inverse_w);
    weights.insert(weights.end(), on_triangle.begin(), on_triangle.end());
  }
  results.numbers("weights on the triangle", weights, 1e-9);
  const Texture texture(texels(scene));
  Frame frame = make_frame(72, 60);
  wall(scene, {&texture, Filter::nearest, Wrap::repeat}, frame);
  results.picture("the wall", frame.color, 1, 6);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"06.1", wrap_scene},
                    {"06.2", textured_mesh_scene},
                    {"06.3", perspective_scene},
                    {"06.4", trilinear_scene}});
}

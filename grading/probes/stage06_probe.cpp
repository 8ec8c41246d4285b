// Runs the exercises of stage 06 on made-up textures, coordinates, triangles and meshes.
#include "common/mesh/shapes.h"
#include "common/texture/textured_mesh.h"
#include "common/texture/textured_triangle.h"

#include "grading/probes/lit_scene.h"
#include "grading/probes/probe.h"

#include <limits>

namespace rasterlab::grading {
namespace {

constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp, Wrap::mirror};
const std::string wrap_names[] = {"repeated", "clamped", "mirrored"};

/// Texels of any colour, so that a wrong one shows; no side is a power of two.
Image<Rgb8> texels(SceneInputs& scene) {
  Image<Rgb8> image{scene.whole(9, 14), scene.whole(5, 8)};
  for (Rgb8& texel : image.pixels()) texel = to_rgb8(scene.color());
  return image;
}

void wrap_scene(SceneInputs& scene, Results& results) {
  std::vector<float> coordinates = {0, 1, -1, 2, 0.25F, -0.25F, 1.25F, -1.75F, 3};
  if (!scene.example()) {
    for (int i = 0; i < 60; ++i) coordinates.push_back(scene.real(-4, 5));
  }
  coordinates.push_back(std::numeric_limits<float>::infinity());
  coordinates.push_back(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < std::size(wraps); ++i) {
    std::vector<double> wrapped;
    for (const float coordinate : coordinates)
      wrapped.push_back(double(wrap_coordinate(coordinate, wraps[i])));
    results.numbers(wrap_names[i], wrapped, 1e-6);
  }
}

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

void trilinear_scene(SceneInputs& scene, Results& results) {
  const Texture texture(texels(scene));
  const float last = static_cast<float>(texture.level_count() - 1);
  for (std::size_t i = 0; i < std::size(wraps); ++i) {
    std::vector<double> colors;
    for (int k = 0; k < 40; ++k) {
      const Vector2<float> uv{scene.real(-1, 2), scene.real(-1, 2)};
      const float level = k % 4 == 0 ? std::floor(scene.real(0, last + 1)) : scene.real(0, last);
      const Vector3<float> color = trilinear_at(texture, wraps[i], uv, level);
      for (const float channel : color) colors.push_back(double(channel));
    }
    results.numbers(wrap_names[i], colors, 1e-5);
  }
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

// What the tests of stage 07 draw, and points that stand for a pixel.
#pragma once

#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/shaders/inputs.h"

#include <algorithm>
#include <random>
#include <string>

namespace rasterlab {

/// A picture of one colour.
inline Image<Rgb8> plain_picture(const Rgb8& color) {
  Image<Rgb8> image(1, 1);
  image.clear(color);
  return image;
}

/// A picture whose texels all differ.
inline Image<Rgb8> colorful_picture(int size) {
  std::mt19937 random(7);
  Image<Rgb8> image(size, size);
  for (Rgb8& pixel : image.pixels()) {
    pixel = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
             static_cast<std::uint8_t>(random())};
  }
  return image;
}

/// The shape with a colour at every vertex.
inline Mesh colored(const std::string& shape) {
  Mesh mesh = make_shape(shape);
  mesh.colors.clear();
  for (const Eigen::Vector3f& position : mesh.positions) {
    mesh.colors.push_back((position + Eigen::Vector3f::Ones()) / 2);
  }
  return mesh;
}

/// A mesh and every map there is, seen from a place off all axes.
struct TestScene {
  Mesh mesh;
  Texture texture;

  explicit TestScene(const std::string& shape, const Image<Rgb8>& picture = colorful_picture(16))
      : mesh(colored(shape)), texture(picture) {}

  static Transforms transforms() {
    return {.view = look_at({0.7F, 0.9F, 2.6F}, {0, 0, 0}, {0, 1, 0}),
            .projection = perspective(45, 1, 0.1F, 20)};
  }

  ShaderInputs inputs() const {
    return {.mesh = mesh,
            .transforms = transforms(),
            .light = {.position = {1, 2, 3, 0}},
            .texture = Sampler{&texture},
            .normal_map = Sampler{&texture},
            .object_normal_map = Sampler{&texture},
            .specular_map = Sampler{&texture}};
  }
};

/// A point seen from the front, all of whose values, and their derivatives, are 0.
template <template <class> class Varyings>
SurfacePoint<Varyings, float> zero_point() {
  SurfacePoint<Varyings, float> point;
  point.front_facing = true;
  for (Varyings<float>* varyings : {&point.value, &point.dx, &point.dy}) {
    std::fill_n(numbers(*varyings), number_count<Varyings>(), 0.0F);
  }
  return point;
}

/// The point of a triangle with these weights of its corners 1 and 2, as `shader` has it.
template <ShaderType Shader>
auto point_of(const Shader& shader, const Mesh& mesh, std::uint32_t triangle, float b1, float b2) {
  auto point = zero_point<Shader::template Varyings>();
  point.value = interpolate<Shader::template Varyings>(
      std::array{shader.vertex(mesh, triangle, 0), shader.vertex(mesh, triangle, 1),
                 shader.vertex(mesh, triangle, 2)},
      CornerWeights<float>{b1, b2});
  return point;
}

}  // namespace rasterlab

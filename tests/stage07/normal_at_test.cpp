#include "common/shaders/draw_shaded.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/toy_lanes.h"

#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;
using Shader = PhongSurface<ConstantColor>;

Vector normal_at(const Vector& mixed) {
  const TestScene scene("cube:1");
  auto point = zero_point<Shader::Varyings>();
  point.value.normal = mixed;
  return VertexNormal(scene.inputs()).normal_at(point);
}

TEST(stage07_normal_at, keeps_the_direction_and_has_unit_length) {
  std::mt19937 random(1);
  std::normal_distribution<float> value;
  for (int i = 0; i < 1000; ++i) {
    const float x = value(random);
    const float y = value(random);
    const Vector mixed(x, y, value(random));
    const Vector expected = mixed.cast<double>().normalized().cast<float>();
    EXPECT_LE((normal_at(mixed) - expected).norm(), 2e-7F)
        << "the normal " << mixed.transpose() << " has length " << mixed.norm();
  }
}

TEST(stage07_normal_at, opposite_normals_that_mix_to_zero_stay_zero) {
  EXPECT_EQ(normal_at({0, 0, 0}), Vector(0, 0, 0)) << "and never NaN";
}

TEST(stage07_normal_at, lanes_equal_one_float) {
  const TestScene scene("cube:1");
  SurfacePoint<Shader::Varyings, ToyLanes<4>> wide;
  std::mt19937 random(2);
  std::normal_distribution<float> value;
  for (int i = 0; i < 3; ++i) {
    for (float& lane : wide.value.normal[i].lane) lane = value(random);
    wide.value.normal[i].lane[3] = 0;
  }
  const auto normals = VertexNormal(scene.inputs()).normal_at(wide);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const Vector one = normal_at({wide.value.normal[0].lane[lane], wide.value.normal[1].lane[lane],
                                  wide.value.normal[2].lane[lane]});
    for (int i = 0; i < 3; ++i) EXPECT_EQ(normals[i].lane[lane], one[i]);
  }
}

/// One triangle whose normals spread, so that the one in the middle looks at the eye and at the
/// light beside it.
Mesh bulge() {
  Mesh mesh;
  mesh.positions = {{-0.8660254F, -0.5F, 0}, {0.8660254F, -0.5F, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (const Vector& position : mesh.positions) {
    mesh.normals.push_back((position + Vector(0, 0, 1)).normalized());
  }
  return mesh;
}

TEST(stage07_normal_at, the_middle_of_a_face_is_as_bright_as_its_normal_says) {
  const Mesh mesh = bulge();
  ShaderInputs inputs = {.mesh = mesh,
                         .transforms = {.view = look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}),
                                        .projection = perspective(40, 1, 0.1F, 20)},
                         .light = {.position = {0, 0, 1, 0}},
                         .material = {.ambient = 0, .diffuse = 0.5F, .specular = 0.5F},
                         .color = Color(1, 1, 1)};
  Frame frame = make_frame(101, 101);
  draw_shaded(mesh, inputs.transforms, Cull::none, Shader(inputs), frame);
  EXPECT_EQ(frame.color(50, 50).r, 255)
      << "in the middle the normal is (0, 0, 1), as light and eye are: all of 0.5 + 0.5. A normal "
         "left as short as mixing made it gives less";
  EXPECT_LT(frame.color(30, 65).r, 140) << "and away from it the highlight is gone";
}

}  // namespace
}  // namespace rasterlab

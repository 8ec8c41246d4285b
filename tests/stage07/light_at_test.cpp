// Light models, each asked at a point by itself.
#include "common/projection/orthographic.h"
#include "common/shaders/draw_shaded.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3d;

/// What a point with this place and normal gets from the light, by a light model on its own.
template <class LightModel>
auto light_at(const ShaderInputs& inputs, const Vector& position, const Vector& normal) {
  auto point = zero_point<PhongSurface<ConstantColor>::Varyings>();
  point.value.position = position.cast<float>();
  point.value.normal = normal.cast<float>();
  return LightModel(inputs).light_at(point, VertexNormal(inputs));
}

Vector toward(const Eigen::Vector4d& goal, const Vector& from) {
  return (goal.head<3>() - goal.w() * from).normalized();
}

struct Expected {
  double ambient;
  double diffuse;
  double specular;
};

enum class Model { phong, blinn_phong };

/// The published formulas; the eye is a point (w = 1) or a direction (w = 0).
Expected reflection(Model model, const ShaderInputs& inputs, const Eigen::Vector4d& eye,
                    const Vector& position, const Vector& normal) {
  const Vector l = toward(inputs.light.position.cast<double>(), position);
  const Vector e = toward(eye, position);
  const Vector mirrored = 2 * normal.dot(l) * normal - l;
  const double facing = normal.dot(l);
  const double cosine = model == Model::phong ? mirrored.dot(e) : normal.dot((l + e).normalized());
  const bool shines = facing > 0 && cosine > 0;
  const auto& [ambient, diffuse, specular, shininess] = inputs.material;
  return {static_cast<double>(inputs.light.ambient_intensity) * static_cast<double>(ambient),
          static_cast<double>(inputs.light.intensity) * static_cast<double>(diffuse) *
              std::max(facing, 0.0),
          static_cast<double>(inputs.light.intensity) * static_cast<double>(specular) *
              (shines ? std::pow(cosine, static_cast<double>(shininess)) : 0)};
}

void expect_light(const Reflection<float>& actual, const Expected& expected) {
  EXPECT_NEAR(actual.ambient, expected.ambient, 1e-6) << "ambient";
  EXPECT_NEAR(actual.diffuse, expected.diffuse, 1e-6) << "diffuse";
  EXPECT_NEAR(actual.specular, expected.specular, 3e-5) << "specular";
}

const Vector eye_place(0.7, 0.9, 2.6);  // where TestScene is seen from

Vector random_vector(std::mt19937& random) {
  std::normal_distribution<double> value;
  const double x = value(random);
  const double y = value(random);
  return {x, y, value(random)};
}

TEST(stage07_light_at, every_point_has_its_own_light_and_eye_direction) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  inputs.material = {.ambient = 0.1F, .diffuse = 0.9F, .specular = 0.7F, .shininess = 20};
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector light = 3 * random_vector(random);
    const float w = i % 2 == 0 ? 0.0F : 1.0F;
    inputs.light = {.position = {static_cast<float>(light.x()), static_cast<float>(light.y()),
                                 static_cast<float>(light.z()), w},
                    .intensity = 0.8F,
                    .ambient_intensity = 0.5F};
    const Vector position = random_vector(random).cast<float>().cast<double>();
    const Vector normal = random_vector(random).normalized();
    const Eigen::Vector4d eye = eye_place.homogeneous();
    expect_light(light_at<Phong>(inputs, position, normal),
                 reflection(Model::phong, inputs, eye, position, normal));
    expect_light(light_at<BlinnPhong>(inputs, position, normal),
                 reflection(Model::blinn_phong, inputs, eye, position, normal));
  }
}

TEST(stage07_light_at, without_perspective_the_eye_is_a_direction) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  inputs.transforms.projection = orthographic(3, 1, 0.1F, 9);
  inputs.material.shininess = 5;
  const Eigen::Vector4d eye = (Eigen::Vector4d() << eye_place.normalized(), 0).finished();
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const Vector position = random_vector(random);
    const Vector normal = random_vector(random).normalized();
    expect_light(light_at<Phong>(inputs, position, normal),
                 reflection(Model::phong, inputs, eye, position, normal));
  }
}

TEST(stage07_light_at, a_mixed_normal_is_made_a_unit_vector) {
  const TestScene scene("cube:1");
  const ShaderInputs inputs = scene.inputs();
  const Vector normal = Vector(1, 2, 3).normalized();
  const Expected whole =
      reflection(Model::phong, inputs, eye_place.homogeneous(), Vector::Zero(), normal);
  expect_light(light_at<Phong>(inputs, Vector::Zero(), 0.5 * normal), whole);
}

TEST(stage07_light_at, an_even_power_of_a_negative_cosine_is_no_highlight) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  // In one plane: the normal 70° from the eye, the light 45° on the eye's side of it, so that the
  // mirrored light is 115° from the eye.
  const Vector toward_eye = eye_place.normalized();
  const Vector across = Vector(0, 1, 0).cross(toward_eye).normalized();
  const auto at_angle = [&](double degrees) -> Vector {
    const double angle = degrees * std::numbers::pi / 180;
    return std::cos(angle) * toward_eye + std::sin(angle) * across;
  };
  inputs.light.position << at_angle(25).cast<float>(), 0;
  for (const float shininess : {0.0F, 2.0F, 10.0F, 128.0F}) {
    inputs.material.shininess = shininess;
    const auto light = light_at<Phong>(inputs, Vector::Zero(), at_angle(70));
    EXPECT_GT(light.diffuse, 0.5) << "the light does reach the surface";
    EXPECT_EQ(light.specular, 0) << "shininess " << shininess;
  }
}

TEST(stage07_light_at, a_back_lit_surface_gets_ambient_light_alone) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  const Vector normal = eye_place.normalized();
  for (const double side : {0.0, 0.4}) {  // straight from behind, and at a slant
    const Vector from_behind = -normal + side * Vector(1, 0, 0);
    inputs.light.position << from_behind.cast<float>(), 0;
    for (const float shininess : {0.0F, 1.0F, 2.0F}) {
      inputs.material.shininess = shininess;
      const auto phong_light = light_at<Phong>(inputs, Vector::Zero(), normal);
      const auto blinn_light = light_at<BlinnPhong>(inputs, Vector::Zero(), normal);
      for (const Reflection<float>& light : {phong_light, blinn_light}) {
        EXPECT_EQ(light.ambient, inputs.material.ambient);
        EXPECT_EQ(light.diffuse, 0) << "a negative cosine takes no light away";
        EXPECT_EQ(light.specular, 0) << "shininess " << shininess;
      }
      EXPECT_EQ((light_at<Diffuse>(inputs, Vector::Zero(), normal).shade), 0);
    }
  }
}

TEST(stage07_light_at, a_zero_normal_gets_ambient_light_alone) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  inputs.material.shininess = 0;
  const auto light = light_at<Phong>(inputs, Vector(0.1, 0.2, 0.3), Vector::Zero());
  EXPECT_EQ(light.ambient, inputs.material.ambient);
  EXPECT_EQ(light.diffuse, 0);
  EXPECT_EQ(light.specular, 0);
}

TEST(stage07_light_at, light_and_eye_opposite_have_no_half_way) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  inputs.light.position << -eye_place.cast<float>(), 0;
  inputs.material.shininess = 0;
  const Vector across = Vector(0, 1, 0).cross(eye_place).normalized() - 0.1 * eye_place;
  const auto light = light_at<BlinnPhong>(inputs, Vector::Zero(), across.normalized());
  EXPECT_EQ(light.specular, 0);
  EXPECT_FALSE(std::isnan(light.diffuse));
}

TEST(stage07_light_at, diffuse_is_the_cosine_times_the_intensity) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  inputs.light = {.position = {0, 0, 2, 1}, .intensity = 0.5F};
  const Vector slanted(0, std::sqrt(0.75), 0.5);
  EXPECT_NEAR((light_at<Diffuse>(inputs, Vector::Zero(), slanted).shade), 0.25, 1e-6);
  EXPECT_NEAR((light_at<Diffuse>(inputs, Vector(0, 0, 3), -slanted).shade), 0.25, 1e-6)
      << "a point beyond the light is lit from the other side";
  EXPECT_EQ((light_at<Unlit>(inputs, Vector::Zero(), slanted).shade), 1);
}

TEST(stage07_light_at, a_specular_map_dims_the_highlight_alone) {
  const TestScene scene("cube:1", plain_picture({51, 255, 255}));
  ShaderInputs inputs = scene.inputs();
  inputs.light.position << eye_place.cast<float>(), 0;
  using Shader = Surface<ConstantColor, VertexNormal, SpecularMapped<Phong>>;
  auto point = zero_point<Shader::Varyings>();
  point.value.position = Vector(0, 0, 0).cast<float>();
  point.value.normal = eye_place.normalized().cast<float>();
  point.value.uv = {0.5F, 0.5F};
  const auto light = SpecularMapped<Phong>(inputs).light_at(point, VertexNormal(inputs));
  EXPECT_NEAR(light.ambient, 0.2, 1e-6);
  EXPECT_NEAR(light.diffuse, 0.8, 1e-6);
  EXPECT_NEAR(light.specular, 0.6 * 51 / 255, 2e-5) << "times the map's red";
}

TEST(stage07_light_at, at_the_corners_it_is_what_the_model_gives_there) {
  const TestScene scene("uv_sphere:8");
  ShaderInputs inputs = scene.inputs();
  inputs.material = {.shininess = 3};
  const GouraudHighlight<ConstantColor> shader(inputs);
  for (std::uint32_t triangle = 0; triangle < scene.mesh.triangles.size(); ++triangle) {
    Expected sum{};
    for (const std::uint32_t vertex : scene.mesh.triangles[triangle]) {
      const Expected corner = reflection(Model::phong, inputs, eye_place.homogeneous(),
                                         scene.mesh.positions[vertex].cast<double>(),
                                         scene.mesh.normals[vertex].cast<double>());
      sum.ambient += corner.ambient / 3;
      sum.diffuse += corner.diffuse / 3;
      sum.specular += corner.specular / 3;
    }
    const auto point = point_of(shader, scene.mesh, triangle, 1.0F / 3, 1.0F / 3);
    expect_light(shader.light.light_at(point, shader.normals), sum);
  }
}

TEST(stage07_light_at, too_much_light_is_white_and_never_wraps) {
  const TestScene scene("uv_sphere:24");
  ShaderInputs inputs = scene.inputs();
  inputs.light.intensity = 40;
  inputs.color = Color(1, 0.8F, 0.6F);
  Frame glaring = make_frame(80, 80);
  draw_shaded(scene.mesh, inputs.transforms, Cull::none, PhongSurface<ConstantColor>(inputs),
              glaring);
  inputs.light.intensity = 1;
  Frame dim = make_frame(80, 80);
  draw_shaded(scene.mesh, inputs.transforms, Cull::none, PhongSurface<ConstantColor>(inputs), dim);
  int white = 0;
  for (std::size_t i = 0; i < dim.color.pixels().size(); ++i) {
    const Rgb8 bright = glaring.color.pixels()[i];
    EXPECT_GE(bright.r, dim.color.pixels()[i].r) << "more light made pixel " << i << " darker";
    if (bright.r == 255 && bright.g == 255 && bright.b == 255) ++white;
  }
  EXPECT_GT(white, 500);
}

}  // namespace
}  // namespace rasterlab

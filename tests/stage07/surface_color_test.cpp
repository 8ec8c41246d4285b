// Surfaces put together from parts: what the parts are asked, what they read, and what they give.
#include "common/shaders/draw_shaded.h"
#include "common/shaders/lattice.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"

#include <string>
#include <type_traits>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Color3 = Vector3<float>;

struct NoVaryings {
  template <class Number>
  struct Varyings {};
};
using AnyPoint = SurfacePoint<NoVaryings::Varyings, float>;

/// Parts that say what they were made to say.
struct GivenColor {
  Color3 color;
  Color3 color_at(const AnyPoint&) const { return color; }
};
struct GivenNormal {
  Color3 normal;
  Color3 normal_at(const AnyPoint&) const { return normal; }
};
struct GivenShade {
  float shade;
  Shade<float> light_at(const AnyPoint&, const GivenNormal&) const { return {shade}; }
};
struct GivenReflection {
  Reflection<float> reflection;
  Reflection<float> light_at(const AnyPoint&, const GivenNormal&) const { return reflection; }
};
struct HeightOfNormal {
  Shade<float> light_at(const AnyPoint& point, const GivenNormal& normals) const {
    return {normals.normal_at(point).z()};
  }
};

void expect_color(const Color3& actual, const Color3& expected, const std::string& what) {
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), 1e-6F)
      << what << ": " << actual.transpose() << ", expected " << expected.transpose();
}

TEST(stage07_surface_color, is_the_color_in_that_light) {
  const GivenNormal normal{{0, 0, 1}};
  const GivenColor color{{0.2F, 0.4F, 0.6F}};
  expect_color(surface_color(AnyPoint{}, color, normal, GivenShade{0.5F}), {0.1F, 0.2F, 0.3F},
               "half the light");
  expect_color(surface_color(AnyPoint{}, color, normal, GivenShade{0}), {0, 0, 0}, "no light");
  expect_color(surface_color(AnyPoint{}, color, normal, GivenReflection{{0.1F, 0.6F, 0.2F}}),
               {0.34F, 0.48F, 0.62F}, "the highlight is white: it is added, not multiplied");
  expect_color(surface_color(AnyPoint{}, color, normal, GivenReflection{{0.5F, 1, 0.3F}}),
               {0.6F, 0.9F, 1}, "what is brighter than white is white");
}

TEST(stage07_surface_color, the_light_is_asked_with_this_surfaces_normals) {
  const GivenColor white{{1, 1, 1}};
  for (const float z : {0.25F, 0.75F}) {
    expect_color(surface_color(AnyPoint{}, white, GivenNormal{{0, 0, z}}, HeightOfNormal{}),
                 {z, z, z}, "a light model that gives the normal's z");
  }
}

TEST(stage07_color_sources, constant_is_what_is_given_else_light_grey) {
  const TestScene scene("cube:1");
  ShaderInputs inputs = scene.inputs();
  expect_color(ConstantColor(inputs).color_at(AnyPoint{}), default_color(), "no colour given");
  inputs.color = Color(0.1F, 0.5F, 0.9F);
  expect_color(ConstantColor(inputs).color_at(AnyPoint{}), *inputs.color, "a colour given");
}

TEST(stage07_color_sources, vertices_are_mixed) {
  const TestScene scene("cube:1");
  const Plain<VertexColor> shader(scene.inputs());
  const auto& [a, b, c] = scene.mesh.triangles[3];
  expect_color(
      shader.fragment(point_of(shader, scene.mesh, 3, 0.5F, 0.25F)),
      0.25F * scene.mesh.colors[a] + 0.5F * scene.mesh.colors[b] + 0.25F * scene.mesh.colors[c],
      "weights ¼, ½, ¼");
}

TEST(stage07_color_sources, a_texture_is_read_at_the_point_with_its_derivatives) {
  Image<Rgb8> picture(2, 2);
  picture(0, 0) = {255, 0, 0};
  picture(1, 0) = {0, 255, 0};
  picture(0, 1) = {0, 0, 255};
  picture(1, 1) = {1, 1, 1};  // so that the mean, 64, is a whole code value
  const TestScene scene("wall:1", picture);
  const ShaderInputs inputs = scene.inputs();
  const Plain<TextureColor> shader(inputs);
  auto point = zero_point<Plain<TextureColor>::Varyings>();
  point.value.uv = {0.25F, 0.75F};
  expect_color(shader.fragment(point), {1, 0, 0}, "the upper left texel: v is up");
  point.value.uv = {0.75F, 0.25F};
  expect_color(shader.fragment(point), Color3::Constant(1.0F / 255), "the lower right texel");
  point.dx.uv = {1, 0};
  expect_color(shader.fragment(point), Color3::Constant(64.0F / 255),
               "a pixel as wide as the texture sees its mean");
  point.dx.uv = {0, 0};
  point.dy.uv = {0, 1};
  expect_color(shader.fragment(point), Color3::Constant(64.0F / 255),
               "a pixel as high as the texture sees its mean");
}

/// What making the shader throws.
template <class Shader>
std::string complaint(const ShaderInputs& inputs) {
  try {
    const Shader shader(inputs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(stage07_surface_color, what_a_part_lacks_is_said_when_it_is_made) {
  const TestScene scene("uv_sphere:4");
  ShaderInputs inputs = scene.inputs();
  inputs.texture = inputs.normal_map = inputs.object_normal_map = inputs.specular_map = {};
  EXPECT_EQ(complaint<Flat<TextureColor>>(inputs), "this shader needs --texture");
  EXPECT_EQ(complaint<Bumped<ConstantColor>>(inputs), "this shader needs --normal-map");
  EXPECT_EQ(complaint<BumpedInObjectSpace<ConstantColor>>(inputs),
            "this shader needs --normal-map");
  inputs.texture = inputs.normal_map = Sampler{&scene.texture};
  EXPECT_EQ(complaint<BumpedShinyPhong<TextureColor>>(inputs), "this shader needs --specular-map");
  Mesh bare = scene.mesh;
  bare.normals.clear();
  bare.colors.clear();
  const ShaderInputs without = {.mesh = bare, .texture = inputs.texture};
  EXPECT_EQ(complaint<PhongSurface<ConstantColor>>(without),
            "this shader needs a mesh with normals");
  EXPECT_EQ(complaint<Plain<VertexColor>>(without), "this shader needs a mesh with colours");
  EXPECT_EQ(complaint<Flat<TextureColor>>(without), "nothing") << "faces have normals of their own";
  bare.texture_coordinates.clear();
  EXPECT_NE(complaint<Plain<TextureColor>>(without), "nothing");
}

/// How many numbers are interpolated at each pixel.
template <class Shader>
int interpolated() {
  return number_count<Shader::template Varyings>();
}

TEST(stage07_varyings, what_no_part_reads_is_not_interpolated) {
  constexpr int uv = 2;
  constexpr int color = 3;
  constexpr int position = 3;
  constexpr int normal = 3;
  constexpr int tangent = 4;  // and its handedness
  constexpr int shade = 1;
  constexpr int reflection = 3;
  EXPECT_EQ(interpolated<Plain<ConstantColor>>(), 0);
  EXPECT_EQ(interpolated<Plain<VertexColor>>(), color);
  EXPECT_EQ(interpolated<Plain<TextureColor>>(), uv);
  EXPECT_EQ(interpolated<Flat<ConstantColor>>(), position + normal);
  EXPECT_EQ(interpolated<Flat<TextureColor>>(), position + normal + uv);
  EXPECT_EQ(interpolated<GouraudSurface<ConstantColor>>(), shade) << "lit at the corners";
  EXPECT_EQ(interpolated<GouraudSurface<TextureColor>>(), shade + uv);
  EXPECT_EQ(interpolated<QuantizedGouraud<ConstantColor>>(), shade);
  EXPECT_EQ(interpolated<GouraudHighlight<ConstantColor>>(), reflection);
  EXPECT_EQ(interpolated<BumpedInObjectSpace<ConstantColor>>(), position + uv);
  EXPECT_EQ(interpolated<Bumped<ConstantColor>>(), position + uv + normal + tangent);
  EXPECT_EQ(interpolated<PhongSurface<ConstantColor>>(), position + normal);
  EXPECT_EQ(interpolated<PhongSurface<VertexColor>>(), position + normal + color);
}

TEST(stage07_varyings, what_several_parts_read_is_interpolated_once) {
  EXPECT_EQ(interpolated<Bumped<TextureColor>>(), interpolated<Bumped<ConstantColor>>());
  EXPECT_EQ(interpolated<BumpedShinyPhong<TextureColor>>(),
            interpolated<BumpedPhong<ConstantColor>>());
}

/// Calls in a class without virtual functions are resolved when it is compiled.
template <class... Shaders>
constexpr bool none_is_polymorphic = !(std::is_polymorphic_v<Shaders> || ...);
static_assert(
    none_is_polymorphic<Plain<VertexColor>, Flat<TextureColor>, GouraudSurface<ConstantColor>,
                        QuantizedGouraud<VertexColor>, BumpedInObjectSpace<ConstantColor>,
                        Bumped<TextureColor>, PhongSurface<VertexColor>,
                        BlinnPhongSurface<TextureColor>, BumpedShinyPhong<TextureColor>, Lattice>);
static_assert(none_is_polymorphic<ConstantColor, VertexColor, TextureColor, FaceNormal,
                                  VertexNormal, ObjectSpaceNormalMap, TangentSpaceNormalMap, Unlit,
                                  Diffuse, Phong, BlinnPhong, SpecularMapped<Phong>,
                                  Gouraud<Diffuse>, Quantized<Gouraud<Diffuse>>>,
              "a virtual call per pixel costs more than many a shader");

/// The four of exercise 07.2, drawn on a coarse sphere in light from infinity.
template <class Shader>
Frame draw_sphere(const TestScene& scene, const ShaderInputs& inputs) {
  Frame frame = make_frame(96, 96);
  frame.ids = Image<std::int32_t>(96, 96, -1);
  draw_shaded(scene.mesh, inputs.transforms, Cull::none, Shader(inputs), frame);
  return frame;
}

TEST(stage07_surface_color, flat_has_one_color_a_face_by_lamberts_law) {
  const TestScene scene("uv_sphere:8");
  ShaderInputs inputs = scene.inputs();
  inputs.color = Color(1, 0.5F, 0.25F);
  const Frame frame = draw_sphere<Flat<ConstantColor>>(scene, inputs);
  const Eigen::Vector3d to_light = Eigen::Vector3d(1, 2, 3).normalized();
  int drawn = 0;
  for (std::size_t i = 0; i < frame.ids.pixels().size(); ++i) {
    const std::int32_t face = frame.ids.pixels()[i];
    if (face < 0) continue;
    ++drawn;
    const auto& [a, b, c] = scene.mesh.triangles[static_cast<std::size_t>(face)];
    const auto corner = [&](std::uint32_t vertex) -> Eigen::Vector3d {
      return scene.mesh.positions[vertex].cast<double>();
    };
    const Eigen::Vector3d normal =
        (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
    const double cosine = std::max(normal.dot(to_light), 0.0);
    const Rgb8 pixel = frame.color.pixels()[i];
    EXPECT_NEAR(pixel.r, 255 * cosine, 0.51) << "face " << face;
    EXPECT_NEAR(pixel.g, 255 * cosine / 2, 0.51) << "face " << face;
    EXPECT_NEAR(pixel.b, 255 * cosine / 4, 0.51) << "face " << face;
  }
  EXPECT_GT(drawn, 2000);
}

TEST(stage07_surface_color, gouraud_mixes_light_and_leaves_the_texture_sharp) {
  const TestScene scene("uv_sphere:8");
  const ShaderInputs inputs = scene.inputs();
  const Frame light = draw_sphere<GouraudSurface<ConstantColor>>(scene, inputs);
  const Frame texture = draw_sphere<Plain<TextureColor>>(scene, inputs);
  const Frame both = draw_sphere<GouraudSurface<TextureColor>>(scene, inputs);
  const double grey = 255 * static_cast<double>(default_color().x());
  for (std::size_t i = 0; i < both.ids.pixels().size(); ++i) {
    const double shade = light.color.pixels()[i].g / grey;
    EXPECT_NEAR(both.color.pixels()[i].g, shade * texture.color.pixels()[i].g, 1.8)
        << "pixel " << i << " is not the texture's colour times the light's";
  }
}

}  // namespace
}  // namespace rasterlab

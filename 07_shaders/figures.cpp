#include "07_shaders/figures.h"

#include "common/image/animation.h"
#include "common/image/files.h"
#include "common/image/operations.h"
#include "common/lighting/turned_light.h"
#include "common/lighting/with_normals.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/rotation.h"
#include "common/shaders/culled.h"
#include "common/shaders/draw_shaded.h"
#include "common/shaders/shaders.h"
#include "common/stage/given_files.h"
#include "common/texture/sample.h"

#include "07_shaders/all_shaders.h"
#include "07_shaders/draw_by_name.h"

#include <array>
#include <cstdio>

namespace rasterlab {
namespace {

constexpr Rgb8 gap_color{40, 40, 40};
const Light from_the_left{.position = {-1, 0.7F, 1, 0}};

Transforms seen_from(const Eigen::Vector3f& eye, Size size) {
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  return {.view = look_at(eye, {0, 0, 0}, {0, 1, 0}),
          .projection = perspective(40, aspect, 0.1F, 20)};
}

/// The planet with all its maps; each of its vertices also has a colour.
struct Planet {
  Mesh mesh;
  Texture color{read_image<Rgb8>(data_path("planet_color.png"))};
  Texture normal_tangent{read_image<Rgb8>(data_path("planet_normal_tangent.png"))};
  Texture normal_object{read_image<Rgb8>(data_path("planet_normal_object.png"))};
  Texture specular{read_image<Rgb8>(data_path("planet_specular.png"))};

  explicit Planet(int subdivision) : mesh(make_shape("uv_sphere", subdivision)) {
    for (const Eigen::Vector3f& position : mesh.positions) {
      mesh.colors.push_back((position + Eigen::Vector3f::Ones()) / 2);
    }
  }

  ShaderInputs inputs(Size size) const {
    return {.mesh = mesh,
            .transforms = seen_from({0, 1, 3}, size),
            .light = from_the_left,
            .material = {.ambient = 0.1F, .diffuse = 1, .specular = 0.5F, .shininess = 30},
            .texture = Sampler{&color},
            .normal_map = Sampler{&normal_tangent},
            .object_normal_map = Sampler{&normal_object},
            .specular_map = Sampler{&specular}};
  }
};

/// The pictures of four shaders, two by two.
Image<Rgb8> two_by_two(const std::vector<Image<Rgb8>>& pictures) {
  return side_by_side(pictures, 2, 2, gap_color);
}

/// Once round in 24 frames, each a file, and all in one that plays. `draw(angle)`, in degrees,
/// gives a frame.
template <class Draw>
void go_round(Run& run, const std::string& name, const Draw& draw) {
  constexpr int frames = 24;
  Animation animation;
  for (int i = 0; i < frames; ++i) {
    const Image<Rgb8> picture = draw(360.0F * static_cast<float>(i) / frames);
    std::array<char, 8> number{};
    std::snprintf(number.data(), number.size(), "_%04d", i);
    run.picture(name + number.data(), picture);
    animation.add(picture);
    run.progress(name + " frame", i + 1, frames);
  }
  run.file(name + ".png", [animation](const auto& path) { animation.write(path, 80); });
}

}  // namespace

void draw_with_holes(Run& run) {
  const Planet planet(48);
  const Size size = run.size({360, 360});
  ShaderInputs inputs = planet.inputs(size);
  inputs.color = Color(0.9F, 0.8F, 0.6F);
  run.picture("07.1_lattice", picture_by_name("lattice", inputs, size));
}

void draw_four_simple_shaders(Run& run) {
  const Planet planet(12);  // coarse, so that faces show
  const Size size = run.size({240, 240});
  ShaderInputs inputs = planet.inputs(size);
  inputs.color = Color(1, 1, 1);
  std::vector<Image<Rgb8>> pictures;
  for (const char* shader : {"flat", "flat_texture", "gouraud", "gouraud_texture"}) {
    pictures.push_back(picture_by_name(shader, inputs, size));
  }
  run.picture("07.2_four_shaders", two_by_two(pictures));
}

void draw_quantized(Run& run) {
  const Mesh knot = make_shape("torus_knot", 24);
  const Size size = run.size({360, 360});
  const ShaderInputs inputs = {.mesh = knot,
                               .transforms = seen_from({0, 1.2F, 2.8F}, size),
                               .light = from_the_left,
                               .color = Color(1, 0.6F, 0)};
  run.picture("07.3_gouraud", picture_by_name("gouraud", inputs, size));
  run.picture("07.3_quantized", picture_by_name("quantized", inputs, size));
}

void draw_normal_maps(Run& run) {
  const Planet planet(32);
  const Size size = run.size({360, 360});
  ShaderInputs inputs = planet.inputs(size);
  inputs.color = Color(0.9F, 0.9F, 0.9F);
  run.picture("07.4_without", picture_by_name("gouraud", inputs, size));
  run.picture("07.4_tangent_space", picture_by_name("normal", inputs, size));
  run.picture("07.4_planet", picture_by_name("normal_texture", inputs, size));
  run.picture("07.4_object_space", picture_by_name("normal_object", inputs, size));
}

// A sphere without its top.
void draw_culled_sides(Run& run) {
  Mesh bowl = Planet(24).mesh;
  std::erase_if(bowl.triangles, [&](const Mesh::Triangle& triangle) {
    return bowl.positions[triangle[0]].y() > 0.4F;
  });
  const Size size = run.size({240, 240});
  const ShaderInputs inputs = {.mesh = bowl,
                               .transforms = seen_from({0, 1.4F, 2.8F}, size),
                               .light = from_the_left,
                               .material = {.ambient = 0.6F, .diffuse = 0.6F}};
  const std::array<std::pair<const char*, Cull>, 3> sides = {
      {{"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}}};
  for (const auto& [name, cull] : sides) {
    Frame frame = make_frame(size.width, size.height);
    const Culled<PhongSurface<VertexColor>> shader{PhongSurface<VertexColor>(inputs), cull};
    draw_shaded(bowl, inputs.transforms, Cull::none, shader, frame);
    run.picture(std::string("07.5_") + name, frame.color);
  }
}

// B.phong's parameters.
void draw_four_phong_shaders(Run& run) {
  const Planet planet(32);
  const Size size = run.size({240, 240});
  ShaderInputs inputs = planet.inputs(size);
  inputs.light = {.position = {0, 0, 1, 0}};
  inputs.material = {.ambient = 0.1F, .diffuse = 1, .specular = 0.5F, .shininess = 10};
  inputs.color = to_color({255, 128, 255});
  ShaderInputs textured = inputs;
  textured.material.specular = 1;
  run.picture("07.6_four_shaders",
              two_by_two({picture_by_name("phong", inputs, size),
                          picture_by_name("phong_normal", inputs, size),
                          picture_by_name("phong_texture", textured, size),
                          picture_by_name("phong_normal_texture", textured, size)}));
}

void draw_turning_light(Run& run) {
  const Planet planet(24);
  const Size alone = run.size({240, 240});
  for (const auto& [name, image] : draw_all_shaders(planet.inputs(alone), alone)) {
    run.picture("07.7_" + name, image);
  }
  const Size size = run.size({80, 80});
  go_round(run, "07.7_light", [&](float angle) {
    ShaderInputs inputs = planet.inputs(size);
    inputs.light = turned_light(from_the_left, {0, 0, 0}, {0, 1, 0}, angle);
    std::vector<Image<Rgb8>> pictures;
    for (const ShadedPicture& shaded : draw_all_shaders(inputs, size)) {
      pictures.push_back(shaded.image);
    }
    return side_by_side(pictures, 6, 1, gap_color);
  });
}

// A.Q31's weights: at the corners of a coarse knot and at every pixel of it, on the bunny; and a
// planet with all its maps, also from a camera that goes round it under the same light.
void draw_phong_per_fragment(Run& run) {
  const Size size = run.size({360, 360});
  const auto inputs_for = [&](const Mesh& mesh, const Eigen::Vector3f& eye) {
    return ShaderInputs{.mesh = mesh,
                        .transforms = seen_from(eye, size),
                        .light = from_the_left,
                        .material = Material{},
                        .color = Color(0.9F, 0.7F, 0.5F)};
  };
  const Mesh knot = make_shape("torus_knot", 8);
  const ShaderInputs inputs = inputs_for(knot, {0, 1.2F, 2.8F});
  Frame frame = make_frame(size.width, size.height);
  draw_shaded(knot, inputs.transforms, Cull::none, GouraudHighlight<ConstantColor>(inputs), frame);
  run.picture("07.8_per_vertex", frame.color);
  run.picture("07.8_per_fragment", picture_by_name("phong", inputs, size));
  const Mesh bunny = with_normals(read_mesh(bunny_path()));
  run.picture("07.8_bunny", picture_by_name("phong", inputs_for(bunny, {0.3F, 0.8F, 3.4F}), size));
  const Planet planet(64);
  run.picture("07.8_planet", picture_by_name("phong_all_maps", planet.inputs(size), size));
  const Size small = run.size({160, 160});
  go_round(run, "07.8_camera", [&](float angle) {
    ShaderInputs from_there = planet.inputs(small);
    const Eigen::Vector4f eye = rotation(angle, {0, 1, 0}) * Eigen::Vector4f(0, 1, 3, 1);
    from_there.transforms = seen_from(eye.head<3>(), small);
    return picture_by_name("phong_all_maps", from_there, small);
  });
}

}  // namespace rasterlab

// The pictures of stage 05 against the ray caster: faces, distances, and light in double precision.
#include "common/lighting/shading.h"
#include "common/mesh/read_mesh.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"

#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

class stage05_witness_of : public testing::TestWithParam<GeometryCase> {};

TEST_P(stage05_witness_of, sees_the_same) {
  EXPECT_GT(expect_geometry("05_lighting", GetParam()).drawn, 0) << "nothing to compare";
}

INSTANTIATE_TEST_SUITE_P(, stage05_witness_of, testing::ValuesIn(built_in_cases()),
                         case_name<testing::TestParamInfo<GeometryCase>>);

/// Lights of every kind: far, near, inside the mesh, from behind.
std::vector<Lighting> lightings() {
  return {
      {.light = {1, 2, 3, 0}},
      {.light = {2, 1, 1.5, 1}, .shininess = 10},
      {.light = {0, 0.3, 0, 1}, .ambient = 0.1, .specular = 1, .shininess = 4},
      {.light = {-1, -2, -1, 0}, .ambient = 0.05, .diffuse = 1, .specular = 0.5, .shininess = 1}};
}

/// Takes a picture in one light and compares it with what another would give.
Agreement compare_lit(const GeometryCase& geometry, const Lighting& lighting, Lighting expected) {
  std::vector<std::string> flags = geometry.viewpoint.flags();
  const std::vector<std::string> light = lighting.flags();
  flags.insert(flags.end(), light.begin(), light.end());
  flags.insert(flags.end(), {"--cull", cull_name(geometry.cull)});
  const auto& [name, mesh_name, viewpoint, width, height, cull] = geometry;
  const Picture picture = take_picture("05_lighting", mesh_name, width, height, flags);
  const Mesh mesh = read_mesh(mesh_name);
  const RayCaster witness(mesh, viewpoint.camera(width, height), width, height, cull);
  const Surface surface(mesh);
  expected.eye = eye_of(viewpoint);
  return compare_colors(witness, picture.color, [&](double, double, const Hit& hit) {
    return shade_gouraud(surface, expected, hit);
  });
}

void expect_lit(const GeometryCase& geometry, const Lighting& lighting) {
  const Agreement agreement = compare_lit(geometry, lighting, lighting);
  std::cout << geometry.mesh << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement << testing::PrintToString(lighting.flags());
}

TEST(stage05_witness, is_not_easily_satisfied) {
  const Lighting lighting = lightings()[1];
  Lighting brighter = lighting;
  brighter.diffuse += 0.02;
  Lighting sharper = lighting;
  sharper.shininess += 1;
  for (const Lighting& other : {brighter, sharper}) {
    const GeometryCase geometry{.name = "knot", .mesh = "builtin:torus_knot"};
    EXPECT_GT(compare_lit(geometry, lighting, other).wrong, 20);
  }
}

TEST_P(stage05_witness_of, is_lit_the_same) {
  for (const Lighting& lighting : lightings()) expect_lit(GetParam(), lighting);
}

TEST(stage05_witness, models_no_one_here_wrote_are_lit_the_same) {
  for (const GeometryCase& geometry : foreign_cases()) {
    SCOPED_TRACE(geometry.mesh);
    expect_lit(geometry, lightings().front());
  }
}

/// Draws with a rung of the shading ladder, which no flag chooses for a mesh.
Image<Rgb8> draw(ShadeFunction rung, const Mesh& mesh, const GeometryCase& geometry,
                 const Lighting& lighting) {
  const Camera camera = geometry.viewpoint.camera(geometry.width, geometry.height);
  Frame frame = make_frame(geometry.width, geometry.height);
  rung({.mesh = mesh,
        .transforms = {.view = camera.view.cast<float>(),
                       .projection = camera.projection.cast<float>()},
        .light = {.position = lighting.light.cast<float>()},
        .material = {.ambient = static_cast<float>(lighting.ambient),
                     .diffuse = static_cast<float>(lighting.diffuse),
                     .specular = static_cast<float>(lighting.specular),
                     .shininess = static_cast<float>(lighting.shininess)},
        .model = lighting.model == Lighting::Model::phong ? ReflectionModel::phong
                                                          : ReflectionModel::blinn_phong,
        .cull = geometry.cull},
       frame);
  return frame.color;
}

struct Rung {
  ShadeFunction draw;
  Shade (*expected)(const Surface&, const Lighting&, const Hit&);
};

TEST_P(stage05_witness_of, every_rung_is_lit_the_same_in_both_models) {
  const GeometryCase& geometry = GetParam();
  const Mesh mesh = read_mesh(geometry.mesh);
  const Surface surface(mesh);
  const RayCaster witness(mesh, geometry.viewpoint.camera(geometry.width, geometry.height),
                          geometry.width, geometry.height, geometry.cull);
  for (const Rung& rung :
       {Rung{rasterlab::shade_flat, shade_flat}, Rung{rasterlab::shade_gouraud, shade_gouraud},
        Rung{rasterlab::shade_phong, shade_phong}}) {
    for (Lighting lighting : lightings()) {
      for (const auto model : {Lighting::Model::phong, Lighting::Model::blinn_phong}) {
        lighting.model = model;
        lighting.eye = eye_of(geometry.viewpoint);
        const Agreement agreement = compare_colors(
            witness, draw(rung.draw, mesh, geometry, lighting),
            [&](double, double, const Hit& hit) { return rung.expected(surface, lighting, hit); });
        EXPECT_EQ(agreement.wrong, 0) << agreement;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab::oracle

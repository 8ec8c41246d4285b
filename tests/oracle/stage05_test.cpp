// The pictures of stage 05 against the ray caster: faces, distances, and light in double precision.
#include "common/lighting/shading.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
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

// --- The exercises' own figures ---

const Eigen::Vector3d clay(0.85, 0.45, 0.3);
const Eigen::Vector4d from_upper_left(-0.5, 0.7, 1, 0);

/// A mesh in one colour, seen from `eye`, which looks at the origin, 40° high.
FigureScene seen_from(const Eigen::Vector3d& eye, Mesh mesh, const Eigen::Vector3d& color,
                      double aspect) {
  mesh.colors.assign(mesh.positions.size(), color.cast<float>());
  return {.mesh = std::move(mesh),
          .camera = {.view = look_at(eye, {0, 0, 0}, {0, 1, 0}),
                     .projection = perspective(40, aspect, 0.1, 20)}};
}

/// A figure lit in one of the three ways.
void expect_lit_figure(const std::string& file, const Image<Rgb8>& figure, const FigureScene& scene,
                       const Lighting& lighting,
                       Shade (*shade)(const Surface&, const Lighting&, const Hit&)) {
  expect_figure(file, figure, scene, [&](const Surface& surface, const Hit& hit) {
    return shade(surface, lighting, hit);
  });
}

/// The bunny, its middle at the origin, its normals left to Surface.
Mesh bunny() {
  Mesh mesh = read_mesh("/usr/share/glmark2/models/bunny.obj");
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  for (Eigen::Vector3f& position : mesh.positions) position -= box.center();
  mesh.normals.clear();
  return mesh;
}

TEST(stage05_figures, ambient_diffuse_specular_and_their_sum) {
  const Figures figures("05_lighting", "05.2");
  const Eigen::Vector3d eye(0, 0, 3.2);
  const FigureScene ball = seen_from(eye, make_shape("uv_sphere:48"), clay, 1);
  const Lighting sum{.light = from_upper_left, .eye = eye.homogeneous()};
  Lighting ambient = sum;
  ambient.diffuse = ambient.specular = 0;
  Lighting diffuse = sum;
  diffuse.ambient = diffuse.specular = 0;
  Lighting specular = sum;
  specular.ambient = specular.diffuse = 0;
  expect_lit_figure("ambient", figures("05.2_ambient.png"), ball, ambient, shade_gouraud);
  expect_lit_figure("diffuse", figures("05.2_diffuse.png"), ball, diffuse, shade_gouraud);
  expect_lit_figure("specular", figures("05.2_specular.png"), ball, specular, shade_gouraud);
  expect_lit_figure("sum", figures("05.2_sum.png"), ball, sum, shade_gouraud);
  const Eigen::Vector3d eye_of_bunny(0, 0.4, 3.9);
  Lighting on_bunny = sum;
  on_bunny.eye = eye_of_bunny.homogeneous();
  expect_lit_figure("bunny", figures("05.2_bunny.png"), seen_from(eye_of_bunny, bunny(), clay, 1),
                    on_bunny, shade_gouraud);
}

TEST(stage05_figures, a_floor_under_a_lamp_and_under_the_sun) {
  const Figures figures("05_lighting", "05.3");
  const Eigen::Vector3d eye(0, 1.6, 2.4);
  const FigureScene floor = seen_from(eye, make_shape("grid:48"), {0.4, 0.6, 0.9}, 200.0 / 140);
  Lighting lighting{.light = {0, 0.5, 0, 1},
                    .ambient = 0.1,
                    .diffuse = 0.7,
                    .specular = 0.6,
                    .shininess = 32,
                    .eye = eye.homogeneous(),
                    .model = Lighting::Model::blinn_phong};
  expect_lit_figure("lamp", figures("05.3_point_light.png"), floor, lighting, shade_phong);
  lighting.light = {0, 0.5, -0.5, 0};
  expect_lit_figure("sun", figures("05.3_light_at_infinity.png"), floor, lighting, shade_phong);
}

TEST(stage05_figures, three_bunnies_in_the_same_light) {
  const std::array<Eigen::Vector3f, 3> colors{
      Eigen::Vector3f(0.9F, 0.4F, 0.3F), {0.4F, 0.8F, 0.4F}, {0.4F, 0.5F, 0.95F}};
  const Mesh one = bunny();
  Mesh all;
  for (int i = 0; i < 3; ++i) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    const Eigen::AngleAxisd turn(i * 2 * std::numbers::pi / 3, Eigen::Vector3d::UnitY());
    for (const Eigen::Vector3f& position : one.positions) {
      const Eigen::Vector3d placed =
          turn * (0.6 * position.cast<double>()) + Eigen::Vector3d(1.2 * (i - 1), 0, 0);
      all.positions.emplace_back(placed.cast<float>());
    }
    for (const auto& [a, b, c] : one.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  const Eigen::Vector3d eye(0, 0.9, 4);
  FigureScene scene = seen_from(eye, all, {0, 0, 0}, 1.4);
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    scene.mesh.colors[i] = colors[i / one.positions.size()];
  }
  expect_lit_figure("bunnies", Figures("05_lighting", "05.4")("05.4_bunnies.png"), scene,
                    {.light = from_upper_left, .eye = eye.homogeneous()}, shade_gouraud);
}

TEST(stage05_figures, flat_gouraud_and_phong_side_by_side) {
  const Figures figures("05_lighting", "05.5");
  const Eigen::Vector3d eye(0.3, 0.2, 3.2);
  const FigureScene ball = seen_from(eye, make_shape("icosphere:2"), clay, 1);
  const Lighting lighting{.light = from_upper_left, .shininess = 40, .eye = eye.homogeneous()};
  expect_lit_figure("flat", figures("05.5_flat.png"), ball, lighting, shade_flat);
  expect_lit_figure("gouraud", figures("05.5_gouraud.png"), ball, lighting, shade_gouraud);
  expect_lit_figure("phong", figures("05.5_phong.png"), ball, lighting, shade_phong);
}

TEST(stage05_figures, the_light_going_round) {
  const Figures figures("05_lighting", "05.6");
  const Eigen::Vector3d eye(0, 0.6, 3);
  const FigureScene knot = seen_from(eye, make_shape("torus_knot:12"), {0.95, 0.75, 0.3}, 1);
  for (const int frame : {0, 13, 50, 87}) {
    const double angle = 2 * std::numbers::pi * frame / 100;
    const std::string file =
        std::string("05.6_light_00") + (frame < 10 ? "0" : "") + std::to_string(frame) + ".png";
    expect_lit_figure(file, figures(file), knot,
                      {.light = {std::sin(angle), 0.3, std::cos(angle), 0},
                       .shininess = 40,
                       .eye = eye.homogeneous()},
                      shade_phong);
  }
}

TEST(stage05_figures, back_and_front_faces_left_out) {
  const Figures figures("05_lighting", "05.7");
  const Eigen::Vector3d eye(0, 1.6, 2.4);
  FigureScene ring = seen_from(eye, make_shape("torus:32"), clay, 160.0 / 120);
  const Lighting lighting{.light = {-1, 0.3, 0.2, 0}, .eye = eye.homogeneous()};
  for (const auto& [file, cull] : {std::pair{"05.7_none_culled.png", Cull::none},
                                   {"05.7_back_culled.png", Cull::back},
                                   {"05.7_front_culled.png", Cull::front}}) {
    ring.cull = cull;
    expect_lit_figure(file, figures(file), ring, lighting, shade_flat);
  }
}

TEST(stage05_figures, highlights_of_power_0_to_10_above_the_sums) {
  const Image<Rgb8> sheet = Figures("05_lighting", "05.8")("05.8_powers.png");
  const Eigen::Vector3d eye(0, 0, 3.2);
  const FigureScene ball = seen_from(eye, make_shape("uv_sphere:32"), clay, 1);
  constexpr int side = 64;
  constexpr int gap = 2;
  for (int power = 0; power <= 10; ++power) {
    for (const bool alone : {true, false}) {
      Image<Rgb8> cell(side, side);
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          cell(x, y) = sheet(power * (side + gap) + x, (alone ? 0 : side + gap) + y);
        }
      }
      Lighting lighting{.light = from_upper_left,
                        .shininess = static_cast<double>(power),
                        .eye = eye.homogeneous()};
      if (alone) lighting.ambient = lighting.diffuse = 0;
      expect_lit_figure("power " + std::to_string(power) + (alone ? " alone" : " in the sum"), cell,
                        ball, lighting, shade_phong);
    }
  }
}

}  // namespace
}  // namespace rasterlab::oracle

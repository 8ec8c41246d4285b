// The pictures of stage 05 against the ray caster: faces, distances, and light in double precision.
#include "common/lighting/shading.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"

#include <algorithm>
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

/// Unit normals of the vertices, each face's counted by the angle it has there.
std::vector<Eigen::Vector3d> normals_by_angle(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.positions.size(), Eigen::Vector3d::Zero());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t corner) -> Eigen::Vector3d {
        return mesh.positions[triangle[(i + corner) % 3]].cast<double>();
      };
      const Eigen::Vector3d to_next = (at(1) - at(0)).normalized();
      const Eigen::Vector3d to_last = (at(2) - at(0)).normalized();
      const double angle = std::acos(std::clamp(to_next.dot(to_last), -1.0, 1.0));
      sums[triangle[i]] += angle * to_next.cross(to_last).normalized();
    }
  }
  for (Eigen::Vector3d& sum : sums) sum.normalize();
  return sums;
}

TEST(stage05_figures, normals_as_colours) {
  const Figures figures("05_lighting", "05.1");
  const Eigen::Vector3d eye(0, 0.4, 3.9);
  const FigureScene scene = seen_from(eye, bunny(), {0, 0, 0}, 1);
  expect_figure("05.1_bunny_mean.png", figures("05.1_bunny_mean.png"), scene,
                [](const Surface& surface, const Hit& hit) {
                  Shade sum{.color = Eigen::Vector3d::Constant(0.5)};
                  for (int i = 0; i < 3; ++i) {
                    sum.color += hit.weights[i] * surface.normal(Surface::corner(hit, i)) / 2;
                  }
                  return sum;
                });
  const std::vector<Eigen::Vector3d> normals = normals_by_angle(scene.mesh);
  expect_figure("05.1_bunny_angle_weighted.png", figures("05.1_bunny_angle_weighted.png"), scene,
                [&](const Surface&, const Hit& hit) {
                  Shade sum{.color = Eigen::Vector3d::Constant(0.5)};
                  const auto& triangle = scene.mesh.triangles[static_cast<std::size_t>(hit.face)];
                  for (std::size_t i = 0; i < 3; ++i) {
                    sum.color +=
                        hit.weights[static_cast<Eigen::Index>(i)] * normals[triangle[i]] / 2;
                  }
                  return sum;
                });
}

/// The cube of eight vertices, its normals drawn as lines of 0.8: what is no line is the cube, and
/// each line ends where it must.
TEST(stage05_figures, normals_of_a_cube_as_lines) {
  Image<Rgb8> figure = Figures("05_lighting", "05.1")("05.1_cube.png");
  Mesh cube;
  for (const float z : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float x : {-1.0F, 1.0F}) cube.positions.emplace_back(x, y, z);
    }
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const FigureScene scene = seen_from({1.5, 1.9, 6.4}, cube, Eigen::Vector3d::Constant(0.25), 1);
  const Eigen::Matrix4d to_clip = scene.camera.to_clip();
  const std::vector<Eigen::Vector3d> by_angle = normals_by_angle(cube);
  const Surface mean(scene.mesh);
  const auto expect_end = [&](const Eigen::Vector3d& position, const Rgb8& color) {
    const Eigen::Vector2d ndc = (to_clip * position.homogeneous()).hnormalized().head<2>();
    const int x = static_cast<int>((ndc.x() + 1) * figure.width() / 2);
    const int y = static_cast<int>((1 - ndc.y()) * figure.height() / 2);
    EXPECT_EQ(figure(x, y), color) << "line to " << position.transpose();
  };
  Hit corner;
  corner.face = 0;
  for (std::size_t face = 0; face < cube.triangles.size(); ++face) {
    for (int i = 0; i < 3; ++i) {
      corner.face = static_cast<int>(face);
      const Hit at = Surface::corner(corner, i);
      const std::size_t vertex = cube.triangles[face][static_cast<std::size_t>(i)];
      expect_end(mean.position(at) + 0.8 * mean.normal(at), {255, 64, 64});
      if ((by_angle[vertex] - mean.normal(at)).norm() > 0.1) {
        expect_end(mean.position(at) + 0.8 * by_angle[vertex], {64, 255, 64});
      }
    }
  }
  const RayCaster witness(scene.mesh, scene.camera, figure.width(), figure.height());
  const Rgb8 grey{64, 64, 64};
  int on_lines = 0;
  for (int y = 0; y < figure.height(); ++y) {
    for (int x = 0; x < figure.width(); ++x) {
      Rgb8& pixel = figure(x, y);
      if (pixel != Rgb8{64, 255, 64} && pixel != Rgb8{255, 64, 64}) continue;
      ++on_lines;
      pixel = witness.cast(x + 0.5, y + 0.5).face >= 0 ? grey : Rgb8{0, 0, 0};
    }
  }
  const Agreement agreement = compare_colors(witness, figure, [](double, double, const Hit&) {
    return Shade{Eigen::Vector3d::Constant(0.25)};
  });
  std::cout << "05.1_cube.png, but for " << on_lines << " pixels of lines: " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
  EXPECT_LT(on_lines, figure.width() * figure.height() / 20);
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
  ring.cull = Cull::none;
  std::erase_if(ring.mesh.triangles, [&](const Mesh::Triangle& triangle) {
    const Eigen::Vector3d a = ring.mesh.positions[triangle[0]].cast<double>();
    const Eigen::Vector3d b = ring.mesh.positions[triangle[1]].cast<double>();
    const Eigen::Vector3d c = ring.mesh.positions[triangle[2]].cast<double>();
    return !((b - a).cross(c - a).dot(lighting.light.head<3>()) > 0);
  });
  expect_lit_figure("05.7_culled_toward_the_light.png", figures("05.7_culled_toward_the_light.png"),
                    ring, lighting, shade_flat);
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

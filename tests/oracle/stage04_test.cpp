// The pictures of stage 04 against the ray caster: which face each pixel shows, how far it is and
// its colour.
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/scene.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"
#include "tests/support/places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

class stage04_witness_of : public testing::TestWithParam<GeometryCase> {};

TEST_P(stage04_witness_of, sees_the_same) {
  expect_geometry("04_projection", GetParam());
}

INSTANTIATE_TEST_SUITE_P(, stage04_witness_of, testing::ValuesIn(built_in_cases()),
                         case_name<testing::TestParamInfo<GeometryCase>>);

/// The colours of the vertices, mixed; without any, grey, as bright as the face looks at the
/// viewer.
Shade shade_face(const Mesh& mesh, const Surface& surface, const Camera& camera, const Hit& hit) {
  if (!mesh.colors.empty()) return {surface.color(hit)};
  const Eigen::Vector3d in_camera =
      camera.view.topLeftCorner<3, 3>() * surface.face_normal(hit.face);
  return {Eigen::Vector3d::Constant(0.8 * (0.15 + 0.85 * std::abs(in_camera.z())))};
}

void expect_colors(const GeometryCase& geometry) {
  const auto& [name, mesh_name, viewpoint, width, height, cull] = geometry;
  std::vector<std::string> flags = viewpoint.flags();
  flags.insert(flags.end(), {"--cull", cull_name(cull)});
  const Picture picture = take_picture("04_projection", mesh_name, width, height, flags);
  const Mesh mesh = read_mesh(mesh_name);
  const Camera camera = viewpoint.camera(width, height);
  const RayCaster witness(mesh, camera, width, height, cull);
  const Surface surface(mesh);
  const Agreement agreement = compare_colors(
      witness, picture.color,
      [&](double, double, const Hit& hit) { return shade_face(mesh, surface, camera, hit); });
  std::cout << mesh_name << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
}

TEST_P(stage04_witness_of, has_the_same_colours) {
  expect_colors(GetParam());
}

TEST(stage04_witness, sees_the_same_of_models_no_one_here_wrote) {
  int drawn = 0;
  for (const GeometryCase& geometry : foreign_cases()) {
    SCOPED_TRACE(geometry.mesh);
    drawn += expect_geometry("04_projection", geometry).drawn;
    expect_colors(geometry);
  }
  EXPECT_GT(drawn, 10000);
}

TEST(stage04_witness, is_not_easily_satisfied) {
  const Viewpoint here;
  const Picture picture = take_picture("04_projection", "builtin:torus", 96, 72, here.flags());
  Viewpoint beside = here;
  beside.eye.x() += 0.004;  // about a tenth of a pixel
  for (const Viewpoint& viewpoint : {here, beside}) {
    const RayCaster witness(read_mesh("builtin:torus"), viewpoint.camera(96, 72), 96, 72);
    const Agreement agreement = compare_geometry(witness, picture);
    EXPECT_EQ(agreement.wrong > 500, viewpoint.eye != here.eye) << agreement;
  }
}

// --- The exercises' own figures ---

Eigen::Matrix4d turned(double degrees, const Eigen::Vector3d& axis) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axis);
  return Eigen::Affine3d(turn).matrix();
}

Eigen::Matrix4d scaled(double x, double y, double z) {
  return Eigen::Affine3d(Eigen::Scaling(x, y, z)).matrix();
}

Eigen::Matrix4d moved(double x, double y, double z) {
  return Eigen::Affine3d(Eigen::Translation3d(x, y, z)).matrix();
}

Shade vertex_color(const Surface& surface, const Hit& hit) {
  return {surface.color(hit)};
}

void expect_cube(const Figures& figures, const std::string& file, const Camera& camera) {
  expect_figure(file, figures(file), {.mesh = make_shape("cube"), .camera = camera}, &vertex_color);
}

/// As seen from (0, 0, 1/per_distance), with planes at z = 1.2 and z = −3 that cut nothing away: a
/// ray needs two ends.
Eigen::Matrix4d from_distance(double per_distance) {
  const double near = 1.2;
  const double far = -3;
  const double near_w = 1 - near * per_distance;
  const double far_w = 1 - far * per_distance;
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
  projection(2, 2) = -(near_w + far_w) / (near - far);
  projection(2, 3) = -near_w - projection(2, 2) * near;
  projection(3, 2) = -per_distance;
  return projection;
}

TEST(stage04_figures, the_cube_from_distance_2_and_5_and_from_infinitely_far) {
  const Figures figures("04_projection", "04.3");
  for (const auto& [file, per_distance] : {std::pair{"04.3_distance_2.png", 0.5},
                                           {"04.3_distance_5.png", 0.2},
                                           {"04.3_infinitely_far.png", 0.0}}) {
    expect_cube(figures, file,
                {.model = turned(20, {1, 0, 0}) * turned(30, {0, 1, 0}) * scaled(0.5, 0.5, 0.5),
                 .projection = from_distance(per_distance)});
  }
}

TEST(stage04_figures, the_cube_by_field_of_view) {
  expect_cube(Figures("04_projection", "04.4"), "04.4_cube.png",
              {.model = turned(20, {1, 0, 0}) * turned(30, {0, 1, 0}),
               .view = moved(0, 0, -4),
               .projection = perspective(60, 1, 0.1, 20)});
}

TEST(stage04_figures, the_bunny_by_field_of_view) {
  Mesh bunny = read_mesh("/usr/share/glmark2/models/bunny.obj");
  bunny.colors.clear();
  const Camera camera{.model = moved(0, 0, 1.5),
                      .view = moved(0, 0, -4),
                      .projection = perspective(60, 1, 0.1, 20)};
  expect_figure("04.4_bunny.png", Figures("04_projection", "04.4")("04.4_bunny.png"),
                {.mesh = bunny, .camera = camera}, [&](const Surface& surface, const Hit& hit) {
                  return shade_face(bunny, surface, camera, hit);
                });
}

TEST(stage04_figures, the_cube_looked_at_and_looked_past) {
  const Figures figures("04_projection", "04.5");
  for (const auto& [file, center] : {std::pair{"04.5_look_at.png", Eigen::Vector3d(0, 0, 0)},
                                     {"04.5_other_center.png", Eigen::Vector3d(-0.4, 0.3, 0)}}) {
    expect_cube(figures, file,
                {.model = scaled(0.5, 0.5, 0.5),
                 .view = look_at({1, 1, 2}, center, {0, 1, 0}),
                 .projection = perspective(60, 1, 0.1, 20)});
  }
}

/// A scene's, whose y goes down.
Camera camera_of(const Scene& scene) {
  const double half_height = scene.height / 2.0;
  const double fovy = 360 / std::numbers::pi * std::atan(half_height / scene.focal_length);
  const double aspect = static_cast<double>(scene.width) / scene.height;
  return {.view = look_at(scene.eye.cast<double>(), scene.look_at.cast<double>(),
                          -scene.up.cast<double>()),
          .projection = perspective(fovy, aspect, 0.1, 100)};
}

TEST(stage04_figures, the_scene_by_its_focal_length_in_pixels) {
  const Scene scene = read_scene(source_folder() / "data/cube.scene");
  expect_figure("04.6_scene.png", Figures("04_projection", "04.6")("04.6_scene.png"),
                {.mesh = read_mesh(scene.mesh), .camera = camera_of(scene)}, &vertex_color);
}

TEST(stage04_figures, one_triangle_and_its_depth) {
  const Figures figures("04_projection", "04.7");
  Mesh triangle;
  triangle.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  triangle.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  triangle.triangles = {{0, 1, 2}};
  const Camera camera{.model = turned(50, {0, 1, 0}),
                      .view = moved(0, 0, -3),
                      .projection = perspective(60, 1, 0.1, 20)};
  expect_figure("04.7_triangle.png", figures("04.7_triangle.png"),
                {.mesh = triangle, .camera = camera}, &vertex_color);

  // The nearest that is seen is white; black is a quarter of the range behind the farthest.
  const Image<Rgb8> picture = figures("04.7_depth.png");
  const RayCaster witness(triangle, camera, picture.width(), picture.height());
  Eigen::AlignedBox1d range;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (witness.cast(x + 0.5, y + 0.5).face < 0) continue;
      range.extend(Eigen::Matrix<double, 1, 1>(witness.plane_depth(x + 0.5, y + 0.5, 0)));
    }
  }
  const double nearest = range.min()[0];
  const double black = range.max()[0] + 0.25 * (range.max()[0] - nearest);
  const Agreement agreement = compare_colors(witness, picture, [&](double x, double y, const Hit&) {
    const double grey = (black - witness.plane_depth(x, y, 0)) / (black - nearest);
    return Shade{Eigen::Vector3d::Constant(grey)};
  });
  std::cout << "04.7_depth.png: " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
}

TEST(stage04_figures, the_cube_with_depth) {
  expect_cube(Figures("04_projection", "04.8"), "04.8_with_depth.png",
              {.view = look_at({2.6, 1.8, 3.6}, {0, 0, 0}, {0, 1, 0}),
               .projection = perspective(45, 1, 0.1, 20)});
}

TEST(stage04_figures, the_cube_without_depth_shows_the_last_face) {
  const Image<Rgb8> picture = Figures("04_projection", "04.8")("04.8_without_depth.png");
  const Mesh cube = make_shape("cube");
  const Surface surface(cube);
  const RayCaster witness(cube,
                          {.view = look_at({2.6, 1.8, 3.6}, {0, 0, 0}, {0, 1, 0}),
                           .projection = perspective(45, 1, 0.1, 20)},
                          picture.width(), picture.height());
  const Agreement agreement = compare_colors(witness, picture, [&](double x, double y, const Hit&) {
    int last = -1;
    for (const Hit& hit : witness.cast_through(x, y)) last = std::max(last, hit.face);
    if (last < 0) return Shade{.color = Eigen::Vector3d::Zero(), .key = {last}};
    return Shade{.color = surface.color(witness.drawn_plane(x, y, last)), .key = {last}};
  });
  std::cout << "04.8_without_depth.png: " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
  EXPECT_GT(agreement.drawn, 10000);
}

/// Four times four squares in two colours, in the plane y = 0.
Mesh checkered_floor() {
  Mesh floor;
  for (int square = 0; square < 16; ++square) {
    const float left = static_cast<float>(square % 4) / 2 - 1;
    const float back = static_cast<float>(square - square % 4) / 8 - 1;
    const auto first = static_cast<std::uint32_t>(floor.positions.size());
    for (const auto& [x, z] : {std::pair{0.0F, 0.0F}, {0.0F, 0.5F}, {0.5F, 0.5F}, {0.5F, 0.0F}}) {
      floor.positions.emplace_back(left + x, 0, back + z);
      const bool orange = (square % 4 + square / 4) % 2 == 0;
      floor.colors.push_back(orange ? Color(0.95F, 0.6F, 0.2F) : Color(0.2F, 0.35F, 0.6F));
    }
    floor.triangles.push_back({first, first + 1, first + 2});
    floor.triangles.push_back({first, first + 2, first + 3});
  }
  return floor;
}

/// Of the rungs, the first loses the triangles with a corner behind the near plane; the second
/// loses pieces that reach too far beyond the picture, and is right elsewhere; the last loses
/// nothing.
TEST(stage04_figures, a_floor_that_reaches_behind_the_eye) {
  const Figures figures("04_projection", "04.9");
  const Camera camera{.view = look_at({0.1, 0.1, 0.35}, {0.13, 0, 0.1}, {0, 1, 0}),
                      .projection = perspective(80, 1.5, 0.0005, 20)};
  const Mesh floor = checkered_floor();
  Mesh in_front = floor;
  std::erase_if(in_front.triangles, [&](const Mesh::Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](std::uint32_t vertex) {
      const Eigen::Vector4d clip =
          camera.to_clip() * floor.positions[vertex].cast<double>().homogeneous();
      return clip.z() < -clip.w();
    });
  });
  expect_figure("04.9_drop.png", figures("04.9_drop.png"), {.mesh = in_front, .camera = camera},
                &vertex_color);
  const Image<Rgb8> whole = figures("04.9_homogeneous.png");
  expect_figure("04.9_homogeneous.png", whole, {.mesh = floor, .camera = camera}, &vertex_color);
  Image<Rgb8> near = figures("04.9_near.png");
  int lost = 0;
  for (std::size_t i = 0; i < near.pixels().size(); ++i) {
    if (near.pixels()[i] != Rgb8{0, 0, 0} || whole.pixels()[i] == Rgb8{0, 0, 0}) continue;
    near.pixels()[i] = whole.pixels()[i];
    ++lost;
  }
  EXPECT_GT(lost, 10000);
  expect_figure("04.9_near.png", near, {.mesh = floor, .camera = camera}, &vertex_color);
}

// --- Figures of lines, which a ray would miss ---

struct Segment {
  Eigen::Vector2d a;
  Eigen::Vector2d b;

  double distance(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d along = b - a;
    const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - (a + t * along)).norm();
  }
};

/// Where the camera sees a point, in pixels.
Eigen::Vector2d in_window(const Camera& camera, const Eigen::Vector3d& point,
                          const Image<Rgb8>& picture) {
  const Eigen::Vector3d ndc = (camera.to_clip() * point.homogeneous()).hnormalized();
  return {(ndc.x() + 1) * picture.width() / 2, (1 - ndc.y()) * picture.height() / 2};
}

std::vector<Segment> edges_of(const Mesh& mesh, const Camera& camera, const Image<Rgb8>& picture) {
  std::vector<Segment> edges;
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto end = [&](std::size_t corner) {
        const Eigen::Vector3d at = mesh.positions[triangle[corner % 3]].cast<double>();
        return in_window(camera, at, picture);
      };
      edges.push_back({end(i), end(i + 1)});
    }
  }
  return edges;
}

/// Half a pixel across, and each coordinate of an end is rounded by half a pixel.
constexpr double off_a_line = 0.5 + 0.7072;

/// Pixels for which `is_line(x, y)` lie on segments, and each segment has such a pixel all along.
template <class IsLine>
void expect_lines(const Image<Rgb8>& picture, const std::vector<Segment>& segments,
                  const IsLine& is_line) {
  std::vector<Eigen::Vector2d> pixels;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!is_line(x, y)) continue;
      pixels.emplace_back(x + 0.5, y + 0.5);
      const bool on_line = std::ranges::any_of(segments, [&](const Segment& segment) {
        return segment.distance(pixels.back()) <= off_a_line;
      });
      EXPECT_TRUE(on_line) << "pixel (" << x << ", " << y << ") is of no line";
    }
  }
  EXPECT_GT(pixels.size(), 100U);
  for (const auto& [a, b] : segments) {
    for (const double t : {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0}) {
      const Eigen::Vector2d point = a + t * (b - a);
      const bool drawn = std::ranges::any_of(
          pixels, [&](const auto& pixel) { return (pixel - point).norm() <= off_a_line + 0.5; });
      EXPECT_TRUE(drawn) << "no line at " << point.transpose();
    }
  }
}

TEST(stage04_figures, wires_of_the_cube) {
  const Image<Rgb8> picture = Figures("04_projection", "04.8")("04.8_wireframe.png");
  const Camera camera{.view = look_at({2.6, 1.8, 3.6}, {0, 0, 0}, {0, 1, 0}),
                      .projection = perspective(45, 1, 0.1, 20)};
  expect_lines(picture, edges_of(make_shape("cube"), camera, picture), [&](int x, int y) {
    return picture(x, y) != Rgb8{0, 0, 0};
  });
}

TEST(stage04_figures, wires_over_the_scene_through_a_pinhole) {
  const Figures figures("04_projection", "04.6");
  const Image<Rgb8> picture = figures("04.6_pinhole.png");
  const Image<Rgb8> filled = figures("04.6_scene.png");
  const Scene scene = read_scene(source_folder() / "data/cube.scene");
  expect_lines(picture, edges_of(read_mesh(scene.mesh), camera_of(scene), picture),
               [&](int x, int y) { return picture(x, y) != filled(x, y); });
}

TEST(stage04_figures, normals_of_a_flattened_ball) {
  Image<Rgb8> picture = Figures("04_projection", "04.10")("04.10_normals.png");
  Mesh ball = make_shape("uv_sphere:12");
  const Camera camera{.model = turned(30, {0, 0, 1}) * scaled(1, 0.35, 1),
                      .projection = orthographic(3.2, 1, -2, 2)};
  const Eigen::Matrix3d as_points = camera.model.topLeftCorner<3, 3>();
  const Eigen::Matrix3d as_normals = as_points.inverse().transpose();
  std::vector<Segment> red;
  std::vector<Segment> green;
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    if (std::abs(ball.positions[i].z()) > 1e-3F) continue;
    const Eigen::Vector3d foot = as_points * ball.positions[i].cast<double>();
    const auto line_along = [&](const Eigen::Vector3d& way) -> Segment {
      const Camera of_world{.projection = camera.projection};
      return {in_window(of_world, foot, picture),
              in_window(of_world, foot + 0.45 * way.normalized(), picture)};
    };
    red.push_back(line_along(as_points * ball.normals[i].cast<double>()));
    green.push_back(line_along(as_normals * ball.normals[i].cast<double>()));
  }
  const auto is = [&](int x, int y, const Rgb8& color) { return picture(x, y) == color; };
  expect_lines(picture, green, [&](int x, int y) { return is(x, y, {64, 255, 64}); });
  std::vector<Segment> both = red;  // green lines cross red ones
  both.insert(both.end(), green.begin(), green.end());
  expect_lines(picture, both, [&](int x, int y) {
    return is(x, y, {64, 255, 64}) || is(x, y, {255, 64, 64});
  });
}

}  // namespace
}  // namespace rasterlab::oracle

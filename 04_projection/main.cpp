// Stage 04: from three dimensions to two. The order is that of the lab sheet, README.md.
#include "common/image/operations.h"
#include "common/lines/draw_line.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/central_projection.h"
#include "common/projection/clip.h"
#include "common/projection/look_at.h"
#include "common/projection/normal_matrix.h"
#include "common/projection/perspective.h"
#include "common/projection/pinhole.h"
#include "common/projection/render.h"
#include "common/projection/scene.h"
#include "common/projection/transforms_2d.h"
#include "common/projection/triangle_pixels.h"
#include "common/projection/viewport.h"
#include "common/stage/stage.h"
#include "common/viewer/camera.h"
#include "common/viewer/viewer.h"

#include "04_projection/any_mesh.h"
#include "04_projection/sketch.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace rasterlab {
namespace {

constexpr Rgb8 grey{128, 128, 128};
constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 red{255, 64, 64};
constexpr Rgb8 green{64, 255, 64};
constexpr Rgb8 blue{96, 128, 255};

constexpr float degree = std::numbers::pi_v<float> / 180;
constexpr float infinity = std::numeric_limits<float>::infinity();

std::string text_of(const auto& matrix) {
  std::ostringstream text;
  text << matrix.format(Eigen::IOFormat(6, 0, "  ", "\n", "  ")) << "\n";
  return text.str();
}

Frame frame_of(const Run& run, Size size = {200, 200}) {
  const Size chosen = run.size(size);
  return make_frame(chosen.width, chosen.height);
}

float aspect_of(const Frame& frame) {
  return static_cast<float>(frame.width()) / static_cast<float>(frame.height());
}

Eigen::Matrix4f rotation(float degrees, const Eigen::Vector3f& axis) {
  return Eigen::Affine3f(Eigen::AngleAxisf(degrees * degree, axis.normalized())).matrix();
}

// The depths that were drawn, near ones bright.
Image<std::uint8_t> depth_picture(const Frame& frame) {
  Image<float> drawn = frame.depth.depths();
  for (float& depth : drawn.pixels()) {
    if (depth == 1) depth = infinity;
  }
  const auto [nearest, farthest] = finite_range(drawn);
  return grey_picture(drawn, farthest + 0.25F * (farthest - nearest) + 1e-6F, nearest);
}

// --- 04.1 ---

void draw_transform(Run& run, const std::string& name, const Eigen::Matrix3f& transform) {
  Sketch sketch(160, 2);
  sketch.letter(Eigen::Matrix3f::Identity(), grey);
  sketch.letter(transform, white);
  run.picture("04.1_" + name, sketch.image());
}

// The same two transforms in either order.
void draw_order(Run& run) {
  const Eigen::Matrix3f turn = rotate_2d(60 * degree);
  const Eigen::Matrix3f move = translate_2d(1, 0);
  Sketch sketch(160, 2);
  sketch.letter(Eigen::Matrix3f::Identity(), grey);
  sketch.letter(turn * move, red);
  sketch.letter(move * turn, green);
  run.picture("04.1_order", sketch.image());
}

void draw_rotation_about_point(Run& run) {
  const Eigen::Vector2f center(1, 0.5F);
  Sketch sketch(160, 2);
  sketch.letter(Eigen::Matrix3f::Identity(), grey);
  for (int i = 1; i <= 3; ++i) {
    sketch.letter(rotate_about_2d(center, static_cast<float>(i) * 90 * degree), white);
  }
  sketch.dot(center, red);
  run.picture("04.1_rotation_about_point", sketch.image());
}

// Parallel rails, and what a matrix whose last row is not 0 0 1 makes of them: they meet where it
// takes the point at infinity they share.
void draw_point_at_infinity(Run& run) {
  Eigen::Matrix3f projective = Eigen::Matrix3f::Identity();
  projective(2, 1) = 0.5F;
  Sketch sketch(160, 2.5F);
  for (const float x : {-1.0F, 0.0F, 1.0F}) {
    const Eigen::Vector2f start = to_plane(projective * point_2d(x, -0.5F));
    sketch.segment({x, -0.5F}, {x, 2.5F}, grey);
    sketch.segment(start, to_plane(projective * point_2d(x, 1000)), white);
  }
  sketch.dot(to_plane(projective * direction_2d(0, 1)), red);
  run.picture("04.1_point_at_infinity", sketch.image());
}

std::string points_and_directions() {
  const Eigen::Matrix3f move = translate_2d(3, 1);
  std::ostringstream text;
  text << "translate_2d(3, 1) takes the point (1, 2) to ("
       << to_plane(move * point_2d(1, 2)).transpose() << ") and the direction (1, 2) to ("
       << (move * direction_2d(1, 2)).head<2>().transpose() << ")\n";
  for (const float w : {1.0F, 0.5F, 0.1F, 0.001F, 0.0F}) {
    text << "(1, 2, " << w << ") is at (" << to_plane({1, 2, w}).transpose() << ")\n";
  }
  return text.str();
}

void transforms_in_the_plane(Run& run) {
  draw_transform(run, "scale", scale_2d(1.75F, 0.75F));
  draw_transform(run, "shear", shear_2d(0.6F, 0));
  draw_transform(run, "rotation", rotate_2d(60 * degree));
  draw_transform(run, "translation", translate_2d(-1.5F, -1));
  draw_order(run);
  draw_rotation_about_point(run);
  draw_point_at_infinity(run);
  run.printout("04.1_points", points_and_directions());
}

// --- 04.2: NDC in three rectangles of one window ---

void draw_outline(Image<Rgb8>& image, const Mesh& mesh, const Eigen::Matrix4f& to_window_matrix) {
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto pixel = [&](std::uint32_t vertex) -> Point {
        const Eigen::Vector4f window = to_window_matrix * mesh.positions[vertex].homogeneous();
        return window.head<2>().array().floor().cast<int>();
      };
      draw_line(image, pixel(triangle[i]), pixel(triangle[(i + 1) % 3]), white);
    }
  }
}

void viewports(Run& run) {
  const Size size = run.size({320, 200});
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  const Mesh sphere = make_shape("icosphere", 2);
  Image<Rgb8> image(size.width, size.height);
  std::string text;
  const std::array<Eigen::Vector4f, 3> places = {
      Eigen::Vector4f(width / 8, height / 8, width * 3 / 4, height * 3 / 4),  // the slide's
      Eigen::Vector4f(0, 0, width / 4, height / 4),
      Eigen::Vector4f(width * 7 / 8, 0, width / 8, height)};
  for (const Eigen::Vector4f& place : places) {
    const Eigen::Matrix4f matrix = viewport(place[0], place[1], place[2], place[3]);
    draw_outline(image, sphere, matrix * scaling({0.95F, 0.95F, 1}));
    text += text_of(matrix) + "\n";
  }
  run.picture("04.2_viewports", image);
  run.printout("04.2_matrices", text);
}

// --- 04.3 ---

// In the course's frame the larger z is nearer: turned over for the depth buffer, and pressed
// together, so that nothing in front of the eye is beyond its limits.
Eigen::Matrix4f to_depth_buffer() {
  return scaling({1, 1, -0.25F});
}

void draw_at_distance(Run& run, const Mesh& mesh, float distance, const std::string& name) {
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.model =
      rotation(20, {1, 0, 0}) * rotation(30, {0, 1, 0}) * scaling({0.6F, 0.6F, 0.6F});
  transforms.projection = to_depth_buffer() * central_projection(distance);
  render_nearest(mesh, transforms, Cull::none, frame);
  run.picture("04.3_" + name, frame.color);
}

void projection_from_a_distance(Run& run) {
  const Mesh cube = make_shape("cube");
  draw_at_distance(run, cube, 2, "distance_2");
  draw_at_distance(run, cube, 5, "distance_5");
  draw_at_distance(run, cube, infinity, "infinitely_far");
  run.printout("04.3_matrix", text_of(central_projection(2)));
}

// --- 04.4 ---

void perspective_of_60_degrees(Run& run) {
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.view = translation({0, 0, -4});
  transforms.model = rotation(20, {1, 0, 0}) * rotation(30, {0, 1, 0});
  transforms.projection = perspective(60, aspect_of(frame), 0.1F, 20);
  render_nearest(make_shape("cube"), transforms, Cull::none, frame);
  run.picture("04.4_cube", frame.color);

  const Subject bunny{.mesh = read_mesh(bunny_path())};
  transforms.model = translation({0, 0, 1.5F});
  draw_any_mesh(bunny)({transforms, Light{}}, frame);
  run.picture("04.4_bunny", frame.color);
  run.printout("04.4_matrix", text_of(perspective(60, 1, 0.1F, 20)));
}

// --- 04.5 ---

void draw_looking_at(Run& run, const Eigen::Vector3f& center, const std::string& name) {
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.model = scaling({0.5F, 0.5F, 0.5F});
  transforms.view = look_at({1, 1, 2}, center, {0, 1, 0});
  transforms.projection = perspective(60, aspect_of(frame), 0.1F, 20);
  render_nearest(make_shape("cube"), transforms, Cull::none, frame);
  run.picture("04.5_" + name, frame.color);
}

void camera_that_looks_at(Run& run) {
  draw_looking_at(run, {0, 0, 0}, "look_at");
  draw_looking_at(run, {-0.5F, 0.5F, 0}, "other_center");
  run.printout("04.5_matrices", text_of(look_at({1, 1, 2}, {0, 0, 0}, {0, 1, 0})) + "\n" +
                                    text_of(look_at({1, 1, 2}, {-0.5F, 0.5F, 0}, {0, 1, 0})));
}

// --- 04.7 ---

void one_triangle(Run& run) {
  Frame frame = frame_of(run);
  Mesh triangle;
  triangle.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  triangle.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  triangle.triangles = {{0, 1, 2}};
  Transforms transforms;
  transforms.model = rotation(50, {0, 1, 0});
  transforms.view = translation({0, 0, -2.5F});
  transforms.projection = perspective(60, aspect_of(frame), 0.1F, 20);
  render_nearest(triangle, transforms, Cull::none, frame);
  run.picture("04.7_triangle", frame.color);
  run.picture("04.7_depth", depth_picture(frame));
}

// --- 04.8 ---

void cube_three_times(Run& run) {
  const Mesh cube = make_shape("cube");
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.view = look_at({2.2F, 1.6F, 3.2F}, {0, 0, 0}, {0, 1, 0});
  transforms.projection = perspective(45, aspect_of(frame), 0.1F, 20);
  render_wireframe(cube, transforms, Color::Ones(), frame.color);
  run.picture("04.8_wireframe", frame.color);
  clear(frame);
  render_in_order(cube, transforms, frame.color);
  run.picture("04.8_without_depth", frame.color);
  clear(frame);
  render_nearest(cube, transforms, Cull::none, frame);
  run.picture("04.8_with_depth", frame.color);
}

}  // namespace
}  // namespace rasterlab

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "04_projection",
                    .exercises = {{"04.1", &transforms_in_the_plane},
                                  {"04.2", &viewports},
                                  {"04.3", &projection_from_a_distance},
                                  {"04.4", &perspective_of_60_degrees},
                                  {"04.5", &camera_that_looks_at},
                                  {"04.7", &one_triangle},
                                  {"04.8", &cube_three_times}},
                    .own_inputs = {viewer({.exercise = &draw_any_mesh})}});
}

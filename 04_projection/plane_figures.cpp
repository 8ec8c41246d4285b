// Exercises 04.1 and 04.2.
#include "common/lines/draw_line.h"
#include "common/mesh/shapes.h"
#include "common/projection/transforms_2d.h"
#include "common/projection/viewport.h"

#include "04_projection/figures.h"
#include "04_projection/sketch.h"
#include "04_projection/text_of.h"

#include <array>
#include <numbers>
#include <sstream>

namespace rasterlab {
namespace {

constexpr Rgb8 grey{128, 128, 128};
constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 red{255, 64, 64};
constexpr Rgb8 green{64, 255, 64};

constexpr float degree = std::numbers::pi_v<float> / 180;

// --- 04.1 ---

void draw_transform(Run& run, const std::string& name, const Eigen::Matrix3f& transform) {
  Sketch sketch(160, 2.2F);
  sketch.letter(Eigen::Matrix3f::Identity(), grey);
  sketch.letter(transform, white);
  run.picture("04.1_" + name, sketch.image());
}

// The same two transforms in either order.
void draw_order(Run& run) {
  const Eigen::Matrix3f turn = rotate_2d(60 * degree);
  const Eigen::Matrix3f move = translate_2d(1, 0);
  Sketch sketch(160, 2.8F);
  sketch.letter(Eigen::Matrix3f::Identity(), grey);
  sketch.letter(turn * move, red);
  sketch.letter(move * turn, green);
  run.picture("04.1_order", sketch.image());
}

void draw_rotation_about_point(Run& run) {
  const Eigen::Vector2f center(1, 0.5F);
  Sketch sketch(160, 2.2F);
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

}  // namespace

void draw_transforms_in_the_plane(Run& run) {
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

namespace {

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

}  // namespace

void draw_viewports(Run& run) {
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

}  // namespace rasterlab

// Exercises 04.7 to 04.10.
#include "common/lines/draw_line.h"
#include "common/mesh/shapes.h"
#include "common/projection/clip.h"
#include "common/projection/look_at.h"
#include "common/projection/normal_matrix.h"
#include "common/projection/orthographic.h"
#include "common/projection/perspective.h"
#include "common/projection/render.h"
#include "common/projection/rotation.h"
#include "common/projection/triangle_pixels.h"
#include "common/projection/viewport.h"
#include "common/viewer/figure.h"

#include "04_projection/figures.h"

#include <cmath>
#include <string>
#include <utility>

namespace rasterlab {

// --- 04.7 ---

void draw_one_triangle(Run& run) {
  Frame frame = frame_of(run);
  Mesh triangle;
  triangle.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  triangle.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  triangle.triangles = {{0, 1, 2}};
  Transforms transforms;
  transforms.model = rotation(50, {0, 1, 0});
  transforms.view = translation({0, 0, -3});
  transforms.projection = perspective(60, aspect_of(frame), 0.1F, 20);
  render_nearest(triangle, transforms, Cull::none, frame);
  run.picture("04.7_triangle", frame.color);
  run.picture("04.7_depth", depth_picture(frame));
}

// --- 04.8 ---

void draw_cube_three_times(Run& run) {
  const Mesh cube = make_shape("cube");
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.view = look_at({2.6F, 1.8F, 3.6F}, {0, 0, 0}, {0, 1, 0});
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

// --- 04.9: on a wide floor, the eye just above it ---

namespace {

// A level floor of squares in two colours; each square is two triangles.
Mesh checkered_floor(int squares) {
  Mesh floor;
  const auto position = [&](int step) {
    return 2 * static_cast<float>(step) / static_cast<float>(squares) - 1;
  };
  for (int row = 0; row < squares; ++row) {
    for (int column = 0; column < squares; ++column) {
      const auto first = static_cast<std::uint32_t>(floor.positions.size());
      for (const auto& [x, z] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}}) {
        floor.positions.emplace_back(position(column + x), 0, position(row + z));
        floor.colors.push_back((row + column) % 2 == 0 ? Color(0.95F, 0.6F, 0.2F)
                                                       : Color(0.2F, 0.35F, 0.6F));
      }
      floor.triangles.push_back({first, first + 1, first + 2});
      floor.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return floor;
}

void draw_clipped(Run& run, const ClipRung& rung) {
  const Mesh floor = checkered_floor(4);
  const Size size = run.size({240, 160});
  Image<Rgb8> image(size.width, size.height);
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  Transforms transforms;
  transforms.view = look_at({0.1F, 0.1F, 0.35F}, {0.13F, 0, 0.1F}, {0, 1, 0});
  transforms.projection = perspective(80, aspect, 0.0005F, 20);
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  TriangleCounts counts;
  for (const Mesh::Triangle& triangle : floor.triangles) {
    const ClipTriangle corners = {to_clip(to_clip_space, floor.positions[triangle[0]]),
                                  to_clip(to_clip_space, floor.positions[triangle[1]]),
                                  to_clip(to_clip_space, floor.positions[triangle[2]])};
    const Rgb8 color = to_rgb8(floor.colors[triangle[0]]);
    for_each_pixel(corners, size.width, size.height, {.clip = rung.clip}, counts,
                   [&](const TrianglePixel& pixel) { image(pixel.x, pixel.y) = color; });
  }
  run.picture(std::string("04.9_") + rung.name, image);
}

}  // namespace

void draw_clipping_ladder(Run& run) {
  for (const ClipRung& rung : clip_ladder) {
    if (run.draws(rung.name)) draw_clipped(run, rung);
  }
}

// --- 04.10: a ball pressed flat, its normals moved like points (red) and like normals (green) ---

void draw_normals(Run& run) {
  Frame frame = frame_of(run);
  Mesh ball = make_shape("uv_sphere", 12);
  ball.colors.assign(ball.positions.size(), Color::Constant(0.3F));
  Transforms transforms;
  transforms.model = rotation(30, {0, 0, 1}) * scaling({1, 0.35F, 1});
  transforms.projection = orthographic(3.2F, aspect_of(frame), -2, 2);
  render_nearest(ball, transforms, Cull::none, frame);

  const Eigen::Matrix3f for_normals = normal_matrix(transforms.model);
  const Eigen::Matrix3f for_points = transforms.model.topLeftCorner<3, 3>();
  const auto draw_at = [&](const Eigen::Vector3f& foot, const Eigen::Vector3f& direction,
                           const Rgb8& color) {
    const auto pixel = [&](const Eigen::Vector3f& point) -> Point {
      const Eigen::Vector4f clip = to_clip(transforms.projection, point);
      return to_window(clip, frame.width(), frame.height()).position.array().floor().cast<int>();
    };
    draw_line(frame.color, pixel(foot), pixel(foot + 0.45F * direction), color);
  };
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    if (std::abs(ball.positions[i].z()) > 1e-3F) continue;  // only around the outline
    const Eigen::Vector3f foot = for_points * ball.positions[i];
    draw_at(foot, (for_points * ball.normals[i]).normalized(), {255, 64, 64});
    draw_at(foot, transform_normal(for_normals, ball.normals[i]), {64, 255, 64});
  }
  run.picture("04.10_normals", frame.color);
}

}  // namespace rasterlab

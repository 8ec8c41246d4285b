// Runs the exercises of stage 03 on made-up depths, points, segments and triangles that pass
// through each other.
#include "common/mesh/shapes.h"
#include "common/zbuffer/depth_buffer.h"
#include "common/zbuffer/draw_depth_line.h"
#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/draw_flat_depth.h"
#include "common/zbuffer/draw_point.h"
#include "common/zbuffer/visibility.h"

#include "grading/probes/probe.h"

#include <limits>

namespace rasterlab::grading {
namespace {

constexpr int width = 48;
constexpr int height = 40;

/// A float's steps near 1, and what two ways to add three products may differ by.
constexpr double depth_tolerance = 2e-6;

/// Depths on a grid, so that some are equal.
float depth(SceneInputs& scene, int from = -8, int to = 8) {
  return static_cast<float>(scene.whole(from, to)) / 8;
}

void depth_buffer_scene(SceneInputs& scene, Results& results) {
  DepthBuffer buffer(scene.whole(5, 30), scene.whole(31, 40));
  results.numbers("the size", {double(buffer.width()), double(buffer.height())});
  std::vector<double> seen;
  for (int i = 0; i < 400; ++i) {
    const Point pixel = scene.pixel(buffer.width(), buffer.height());
    const float z = depth(scene);
    seen.push_back(buffer.test(pixel.x(), pixel.y(), z) ? 1 : 0);
    if (i % 2 == 0) buffer.write(pixel.x(), pixel.y(), z);
    seen.push_back(buffer.test(pixel.x(), pixel.y(), z) ? 1 : 0);
  }
  results.numbers("what test() says, 1 for seen", seen);
  results.number("whether a depth that is not a number is seen",
                 buffer.test(0, 0, std::numeric_limits<float>::quiet_NaN()) ? 1 : 0);
  results.values("the stored depths", buffer.depths(), 0);
  buffer.clear();
  results.values("the cleared buffer", buffer.depths(), 0);
}

void point_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(width, height);
  DepthBuffer buffer(width, height);
  for (int i = 0; i < 3000; ++i) {
    const Point pixel = scene.pixel(width + 8, height + 8) - Point(4, 4);
    draw_point(image, buffer, pixel, depth(scene, -10, 10), scene.color());
  }
  draw_point(image, buffer, {1, 1}, std::numeric_limits<float>::quiet_NaN(), {1, 0, 1});
  results.picture("the points", image);
  results.values("their depths", buffer.depths(), 0);
}

void line_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(width, height);
  DepthBuffer buffer(width, height);
  const auto end = [&] {
    const Point pixel = scene.pixel(width + 20, height + 20) - Point(10, 10);
    const float z = scene.real(-1.2F, 1.2F);
    return LineEnd{pixel, z, scene.color()};
  };
  for (int i = 0; i < (scene.example() ? 2 : 30); ++i) {
    const LineEnd a = end();
    draw_depth_line(image, buffer, a, end());
  }
  const LineEnd point = end();
  draw_depth_line(image, buffer, point, point);
  results.picture("the segments", image, 1, 2);
  results.values("their depths", buffer.depths(), depth_tolerance, 2);
}

void triangle_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(width, height);
  DepthBuffer buffer(width, height);
  for (int i = 0; i < (scene.example() ? 3 : 8); ++i) {
    std::array<DepthCorner, 3> corners;
    for (DepthCorner& corner : corners) {
      const float x = scene.real(-10, width + 10);
      corner.position = {x, scene.real(-10, height + 10)};
      corner.z = scene.real(-1.2F, 1.2F);
      corner.color = scene.color();
    }
    draw_depth_triangle(image, buffer, corners);
  }
  // Where two triangles meet, rounding decides a pixel.
  results.picture("the triangles", image, 1, 4);
  results.values("their depths", buffer.depths(), depth_tolerance, 4);
}

Image<float> as_values(const VisibleTriangles& seen) {
  Image<float> values(seen.width(), seen.height());
  for (std::size_t i = 0; i < seen.pixels().size(); ++i)
    values.pixels()[i] = static_cast<float>(seen.pixels()[i]);
  return values;
}

void visibility_scene(SceneInputs& scene, Results& results) {
  VisibilityScene made{.width = width, .height = height, .near = 0.5F, .far = 100, .triangles = {}};
  for (int i = 0; i < 9; ++i) {
    VisibilityTriangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float x = scene.real(-5, width + 5);
      triangle.corners[corner] = {x, scene.real(-5, height + 5)};
      triangle.distances[corner] = scene.real(0.6F, i % 3 == 0 ? 3 : 90);
    }
    made.triangles.push_back(triangle);
    if (i % 4 == 0) made.triangles.push_back(triangle);  // of equals, the earliest
  }
  // Rounding decides a few pixels where triangles meet; with 16 bit, more.
  results.values("seen with 16 bit", as_values(seen_by_zbuffer_16(made)), 0, 40);
  results.values("seen with 24 bit", as_values(seen_by_zbuffer_24(made)), 0, 6);
  results.values("seen with a float", as_values(seen_by_zbuffer_float(made)), 0, 6);
  results.values("seen with a reversed float", as_values(seen_by_zbuffer_reversed(made)), 0, 6);
}

void flat_mesh_scene(SceneInputs& scene, Results& results) {
  Mesh mesh = make_shape(scene.example() ? "torus:8" : "torus_knot:6");
  const Eigen::AngleAxisf turn(scene.real(0, 3), Eigen::Vector3f(1, 2, 3).normalized());
  for (Eigen::Vector3f& position : mesh.positions) position = turn * position;
  Image<Rgb8> image(width, height);
  DepthBuffer buffer(width, height);
  draw_flat_depth(image, buffer, mesh);
  results.picture("the mesh", image, 1, 6);
  results.values("its depth", buffer.depths(), depth_tolerance, 6);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"03.1", depth_buffer_scene},
                    {"03.2", point_scene},
                    {"03.3", line_scene},
                    {"03.4", triangle_scene},
                    {"03.5", visibility_scene},
                    {"03.6", flat_mesh_scene}});
}

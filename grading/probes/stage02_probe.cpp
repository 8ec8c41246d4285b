// Runs the exercises of stage 02 on made-up triangles: of every winding, thin, flat, half outside.
#include "common/mesh/shapes.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/draw_triangle_wireframe.h"
#include "common/triangles/fill_edge_functions.h"
#include "common/triangles/fill_faults.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fill_triangle_gradient.h"
#include "common/triangles/interpolate_attributes.h"

#include "grading/probes/probe.h"

namespace rasterlab::grading {

void scanline_scene(SceneInputs& scene, Results& results);  // stage02/triangle_scanline.cpp

namespace {

constexpr int size = 60;

Point pixel_around(SceneInputs& scene) {
  return scene.pixel(size + 24, size + 24) - Point(12, 12);
}

std::array<Point, 3> pixel_triangle(SceneInputs& scene) {
  const Point a = pixel_around(scene);
  const Point b = pixel_around(scene);
  return {a, b, pixel_around(scene)};
}

/// Corners on a grid of `steps` a pixel.
Corners triangle(SceneInputs& scene, int steps) {
  Corners corners;
  for (auto& corner : corners) {
    const double x = scene.whole(-8 * steps, (size + 8) * steps);
    corner = Eigen::Vector2d(x, scene.whole(-8 * steps, (size + 8) * steps)) / steps;
  }
  return corners;
}

void wireframe_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(size, size);
  if (scene.example()) {
    draw_triangle_wireframe(image, {Point(10, 10), Point(50, 20), Point(20, 50)}, {255, 255, 255});
  } else {
    for (int i = 0; i < 4; ++i)
      draw_triangle_wireframe(image, pixel_triangle(scene), to_rgb8(scene.color()));
  }
  results.picture("the sides", image);
}

void gradient_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(size, size);
  if (scene.example()) {
    fill_triangle_gradient(image, {Point(5, 8), Point(52, 20), Point(20, 50)},
                           {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)});
  } else {
    for (int i = 0; i < 4; ++i) {
      const Color a = scene.color();
      const Color b = scene.color();
      fill_triangle_gradient(image, pixel_triangle(scene), {a, b, scene.color()});
    }
  }
  results.picture("the triangles", image, 1, 12);
}

void exact_fill_scene(SceneInputs& scene, Results& results) {
  std::vector<Corners> triangles;
  if (scene.example()) {
    // The figure's three, at a third of their size.
    for (const Corners& corners : {Corners{Eigen::Vector2d(10, 70), {50, 160}, {70, 80}},
                                   Corners{Eigen::Vector2d(180, 50), {150, 1}, {70, 180}},
                                   Corners{Eigen::Vector2d(180, 150), {120, 160}, {130, 180}}}) {
      triangles.push_back({corners[0] / 3, corners[1] / 3, corners[2] / 3});
    }
  } else {
    for (int i = 0; i < 6; ++i) triangles.push_back(triangle(scene, i < 3 ? 2 : 256));
    triangles.push_back({Eigen::Vector2d(3, 3), {30, 3}, {50, 3}});  // flat: covers nothing
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::string name = "triangle " + std::to_string(i + 1);
    for (const bool reversed : {false, true}) {
      Corners corners = triangles[i];
      if (reversed) std::swap(corners[1], corners[2]);
      Image<Rgb8> image(size, size);
      fill_edge_functions(image, corners, {255, 255, 255});
      results.picture(name + (reversed ? ", the other way round" : ""), image);
    }
  }
}

void attributes_scene(SceneInputs& scene, Results& results) {
  for (const Eigen::Index count : {1, 3, 8}) {
    Eigen::MatrixX3d attributes(count, 3);
    for (Eigen::Index row = 0; row < count; ++row) {
      for (Eigen::Index column = 0; column < 3; ++column)
        attributes(row, column) = double(scene.real(-9, 9));
    }
    const double w1 = double(scene.real(0, 0.6F));
    const double w2 = double(scene.real(0, 0.4F));
    const Eigen::VectorXd at = interpolate_attributes(attributes, {1 - w1 - w2, w1, w2});
    results.numbers(std::to_string(count) + " attributes", {at.begin(), at.end()}, 1e-10);
    const Eigen::VectorXd same =
        interpolate_attributes(Eigen::MatrixX3d::Constant(count, 3, 0.1), {1 - w1 - w2, w1, w2});
    results.numbers("where all corners agree", {same.begin(), same.end()});
  }
}

/// A fill with every fault: misses, adds, and depends on order and place.
void crooked_fill(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const Corners crooked = {corners[0], corners[1] + Eigen::Vector2d(2, 0.7),
                           corners[2] - Eigen::Vector2d(0, 1)};
  fill_edge_functions(image, crooked, color);
  if (image.width() > 0 && static_cast<int>(corners[0].x()) % 2 == 0) image(0, 0) = color;
}

void faults_scene(SceneInputs& scene, Results& results) {
  TriangleSample sample{.name = "made up", .size = 64, .triangles = {}};
  for (int i = 0; i < 6; ++i) {
    Corners corners;
    for (auto& corner : corners) {
      const double x = scene.whole(4 * 8, 58 * 8);
      corner = Eigen::Vector2d(x, scene.whole(4 * 8, 58 * 8)) / 8;
    }
    sample.triangles.push_back(corners);
  }
  const auto add = [&](const std::string& name, FillTriangle fill) {
    const FillFaults faults = fill_faults(fill, sample);
    results.number(name + ": missing", faults.missing, 1e-6);
    results.number(name + ": extra", faults.extra, 1e-6);
    results.number(name + ": doubled", faults.doubled, 1e-6);
    results.number(name + ": order", faults.order, 1e-6);
    results.number(name + ": rotation", faults.rotation, 1e-6);
  };
  add("an exact fill", &fill_edge_functions);
  add("a crooked fill", &crooked_fill);
}

void flat_faces_scene(SceneInputs& scene, Results& results) {
  std::vector<double> intensities;
  for (int i = 0; i < 12; ++i) {
    const float x = scene.real(-1, 1);
    const float y = scene.real(-1, 1);
    intensities.push_back(
        double(flat_intensity(Eigen::Vector3f(x, y, scene.real(-1, 1)).normalized())));
  }
  results.numbers("flat_intensity() of some normals", intensities, 1e-6);
  Mesh mesh = make_shape(scene.example() ? "icosphere:2" : "torus:8");
  const Eigen::AngleAxisf turn(scene.real(0, 3), Eigen::Vector3f(1, 2, 3).normalized());
  for (Eigen::Vector3f& position : mesh.positions) position = turn * position;
  Image<Rgb8> image(size, size);
  draw_flat_faces(image, mesh);
  results.picture("the mesh", image, 1);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"02.1", wireframe_scene},
                    {"02.2", scanline_scene},
                    {"02.3", gradient_scene},
                    {"02.4", exact_fill_scene},
                    {"02.5", attributes_scene},
                    {"02.6", faults_scene},
                    {"02.7", flat_faces_scene}});
}

// Runs the exercises of stage 04 on made-up matrices, cameras, points and triangles.
#include "common/mesh/shapes.h"
#include "common/projection/central_projection.h"
#include "common/projection/clip.h"
#include "common/projection/look_at.h"
#include "common/projection/normal_matrix.h"
#include "common/projection/orthographic.h"
#include "common/projection/perspective.h"
#include "common/projection/pinhole.h"
#include "common/projection/render.h"
#include "common/projection/transforms_2d.h"
#include "common/projection/vertex_stage.h"
#include "common/projection/viewport.h"

#include "grading/probes/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlab::grading {
namespace {

constexpr double float_tolerance = 2e-5;

template <class Derived>
std::vector<double> as_numbers(const Eigen::MatrixBase<Derived>& matrix) {
  std::vector<double> numbers;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      numbers.push_back(static_cast<double>(matrix(row, column)));
  }
  return numbers;
}

template <class Derived>
void add(Results& results, const std::string& name, const Eigen::MatrixBase<Derived>& matrix) {
  results.numbers(name, as_numbers(matrix), float_tolerance);
}

Eigen::Vector4f vector_4(SceneInputs& scene, float low, float high) {
  const Eigen::Vector3f xyz = scene.vector(low, high);
  return {xyz.x(), xyz.y(), xyz.z(), scene.real(low, high)};
}

void transforms_scene(SceneInputs& scene, Results& results) {
  const float a = scene.real(0.3F, 2);
  const float b = scene.real(-2, -0.2F);
  add(results, "scale", scale_2d(a, b));
  add(results, "shear", shear_2d(a, b));
  add(results, "rotation", rotate_2d(a));
  add(results, "translation", translate_2d(a, b));
  add(results, "rotation about a point", rotate_about_2d({3 * a, b}, b));
  add(results, "a point moved", rotate_about_2d({a, b}, a) * point_2d(1, 2));
  add(results, "a direction moved", translate_2d(a, b) * direction_2d(1, 2));
  add(results, "to the plane", to_plane({a, b, scene.real(0.2F, 3)}));
  add(results, "a point at infinity", to_plane({a, b, 0}));
  add(results, "a point at infinity on an axis", to_plane({0, b, 0}));
}

void viewport_scene(SceneInputs& scene, Results& results) {
  add(results, "translation", translation(scene.vector(-3, 3)));
  add(results, "scaling", scaling(scene.vector(-3, 3)));
  const float width = scene.example() ? 640 : scene.real(10, 500);
  const float height = scene.example() ? 480 : scene.real(10, 500);
  const float x = scene.real(0, 50);
  const float y = scene.real(0, 50);
  const Eigen::Matrix4f matrix = viewport(x, y, width, height);
  add(results, "where the corners of NDC land",
      matrix * (Eigen::Matrix<float, 4, 2>() << -1, 1, 1, -1, 0.5F, -0.5F, 1, 1).finished());
  add(results, "where a point lands", matrix * scene.vector(-1, 1).homogeneous());
}

void central_projection_scene(SceneInputs& scene, Results& results) {
  const Eigen::Matrix4f matrix = central_projection(scene.example() ? 2 : scene.real(0.5F, 9));
  add(results, "the matrix", matrix);
  add(results, "a point", (matrix * scene.vector(-1, 0).homogeneous()).hnormalized());
  add(results, "an infinite distance", central_projection(std::numeric_limits<float>::infinity()));
}

void perspective_scene(SceneInputs& scene, Results& results) {
  const float fovy = scene.example() ? 60 : scene.real(20, 120);
  const float aspect = scene.example() ? 1 : scene.real(0.4F, 2.5F);
  const float near = scene.example() ? 0.1F : scene.real(0.05F, 2);
  const float far = scene.example() ? 20 : scene.real(3, 200);
  const Eigen::Matrix4f matrix = perspective(fovy, aspect, near, far);
  add(results, "the matrix", matrix);
  add(results, "a point of the near plane",
      (matrix * Eigen::Vector4f(0.1F, 0.2F, -near, 1)).hnormalized());
  add(results, "a point of the far plane",
      (matrix * Eigen::Vector4f(0.1F, 0.2F, -far, 1)).hnormalized());
  add(results, "far at infinity",
      perspective(fovy, aspect, near, std::numeric_limits<float>::infinity()));
}

void look_at_scene(SceneInputs& scene, Results& results) {
  if (scene.example()) {
    add(results, "eye (1, 1, 2), center 0", look_at({1, 1, 2}, {0, 0, 0}, {0, 1, 0}));
    return;
  }
  const Eigen::Vector3f eye = scene.vector(-5, 5);
  const Eigen::Vector3f center = scene.vector(-2, 2) + Eigen::Vector3f(7, 0, 0);
  const Eigen::Vector3f up = scene.vector(-1, 1) + Eigen::Vector3f(0, 3, 0);
  const Eigen::Matrix4f view = look_at(eye, center, up);
  add(results, "the matrix", view);
  add(results, "where the eye lands", view * eye.homogeneous());
  add(results, "where the center lands", view * center.homogeneous());
  add(results, "up along the line of sight",
      look_at(eye, eye - Eigen::Vector3f(0, 4, 0), {0, 1, 0}));
  add(results, "center on the eye", look_at(eye, eye, up));
}

void pinhole_scene(SceneInputs& scene, Results& results) {
  const Eigen::Vector3f eye = scene.example() ? Eigen::Vector3f(0, 0, -3) : scene.vector(-4, -2);
  const Eigen::Vector3f target = scene.example() ? Eigen::Vector3f(0, 0, 0) : scene.vector(-1, 1);
  const Eigen::Matrix4f camera = world_to_camera(eye, target, {0, -1, 0});
  const float focal_length = scene.real(100, 600);
  const int width = scene.whole(64, 640);
  const Eigen::Matrix3f k = calibration(focal_length, width, scene.whole(64, 480));
  add(results, "world to camera", camera);
  add(results, "the calibration", k);
  add(results, "the canonical projection", canonical_projection());
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 12; ++i) points.push_back(scene.vector(-1, 1));
  points.emplace_back(2 * eye - target);  // behind the camera
  std::vector<double> numbers;
  for (const Eigen::Vector3f& point : project_points(points, camera, k)) {
    const std::vector<double> xyz = as_numbers(point);
    numbers.insert(numbers.end(), xyz.begin(), xyz.end());
  }
  results.numbers("projected points", numbers, 1e-3);
}

Eigen::Matrix4f camera_matrix(SceneInputs& scene) {
  const Eigen::Matrix4f view = look_at(
      scene.example() ? Eigen::Vector3f(1, 1, 2) : scene.vector(1, 2), {0, 0, 0}, {0, 1, 0});
  return perspective(60, 1, 0.1F, 20) * view;
}

void vertex_scene(SceneInputs& scene, Results& results) {
  const Eigen::Matrix4f matrix = camera_matrix(scene);
  const int width = scene.whole(20, 700);
  const int height = scene.whole(20, 700);
  std::vector<double> clips;
  std::vector<double> windows;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector4f clip = to_clip(matrix, scene.vector(-0.5F, 0.5F));
    const WindowPoint window = to_window(clip, width, height);
    const std::vector<double> numbers = as_numbers(clip);
    clips.insert(clips.end(), numbers.begin(), numbers.end());
    windows.insert(windows.end(), {double(window.position.x()), double(window.position.y()),
                                   double(window.depth)});
  }
  // The order of the operations is part of the contract: every bit counts.
  results.numbers("points in clip space", clips);
  results.numbers("points in the window", windows);
}

Transforms transforms(SceneInputs& scene) {
  Transforms made;
  made.view = look_at(scene.example() ? Eigen::Vector3f(1, 1, 2) : scene.vector(1, 2), {0, 0, 0},
                      {0, 1, 0});
  made.projection = perspective(60, 1, 0.1F, 20);
  made.model.topLeftCorner<3, 3>() *= scene.real(0.5F, 0.8F);
  return made;
}

void render_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("cube");
  const Transforms way = transforms(scene);
  Image<Rgb8> wireframe(96, 80);
  render_wireframe(mesh, way, Color(1, 1, 1), wireframe);
  results.picture("the wireframe", wireframe);
  Image<Rgb8> in_order(96, 80);
  render_in_order(mesh, way, in_order);
  results.picture("filled in order", in_order, 1);
  Frame frame = make_frame(96, 80);
  frame.distance = Image<float>(96, 80);
  frame.ids = Image<std::int32_t>(96, 80);
  clear(frame);
  render_nearest(mesh, way, Cull::none, frame);
  results.picture("the nearest", frame.color, 1);
  results.values("its depth", frame.depth.depths(), 1e-5);
  std::vector<double> distances;
  for (const float distance : frame.distance.pixels()) {
    distances.push_back(std::isfinite(distance) ? double(distance) : -1);
  }
  results.numbers("its distances, -1 where nothing is", distances, 1e-4);
  std::vector<double> is_drawn;
  for (const std::int32_t id : frame.ids.pixels()) is_drawn.push_back(id >= 0 ? 1 : 0);
  results.numbers("where it has a triangle", is_drawn, 0);
}

/// The corners of a polygon from the least on, so that it does not matter where an answer begins.
std::vector<double> polygon_numbers(ClipPolygon polygon) {
  const auto less = [](const ClipVertex& a, const ClipVertex& b) {
    return std::lexicographical_compare(a.weights.begin(), a.weights.end(), b.weights.begin(),
                                        b.weights.end());
  };
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), less),
              polygon.end());
  std::vector<double> numbers;
  for (const ClipVertex& vertex : polygon) {
    for (const float number : vertex.position) numbers.push_back(double(number));
    for (const float number : vertex.weights) numbers.push_back(double(number));
  }
  return numbers;
}

void clip_scene(SceneInputs& scene, Results& results) {
  const Eigen::Vector2f guard = guard_band(640, 480);
  for (int i = 0; i < 10; ++i) {
    ClipTriangle triangle = {vector_4(scene, -2, 2), vector_4(scene, -2, 2),
                             vector_4(scene, -2, 2)};
    if (i == 0) {
      for (Eigen::Vector4f& corner : triangle) corner.w() = 5;  // wholly inside
    } else if (i < 4) {
      triangle[0].x() *= 4000;  // beyond the guard band
    } else {
      triangle[0].w() = 5;  // in front, so that something is left
    }
    const std::string name = "triangle " + std::to_string(i + 1);
    results.numbers(name + ", homogeneous", polygon_numbers(clip_homogeneous(triangle, guard)),
                    1e-5);
    results.numbers(name + ", near", polygon_numbers(clip_near(triangle, guard)), 1e-5);
    results.numbers(name + ", drop", polygon_numbers(clip_drop(triangle, guard)), 1e-5);
  }
}

/// Up to a positive factor.
std::vector<double> direction_numbers(const Eigen::Matrix3f& matrix) {
  const float largest = matrix.cwiseAbs().maxCoeff();
  return as_numbers((largest > 0 ? (matrix / largest).eval() : matrix).eval());
}

void normal_scene(SceneInputs& scene, Results& results) {
  Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
  model.topRightCorner<3, 1>() = scene.vector(-3, 3);
  const Eigen::Vector3f factors{scene.real(0.2F, 0.6F), scene.real(1, 2), scene.real(2, 4)};
  const Eigen::AngleAxisf turn{scene.real(0.3F, 2), scene.direction()};
  model.topLeftCorner<3, 3>() = turn.toRotationMatrix() * factors.asDiagonal();
  results.numbers("the matrix under an uneven scale", direction_numbers(normal_matrix(model)),
                  float_tolerance);
  for (int i = 0; i < 3; ++i)
    add(results, "a normal moved",
        transform_normal(normal_matrix(model), scene.vector(-1, 1).normalized()));
  model.row(0) *= -1;
  results.numbers("under a mirror", direction_numbers(normal_matrix(model)), float_tolerance);
  Eigen::Matrix4f line = Eigen::Matrix4f::Zero();
  line(0, 0) = 1;
  add(results, "pressed to a line", transform_normal(normal_matrix(line), {0, 1, 0}));
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"04.1", transforms_scene},
                    {"04.2", viewport_scene},
                    {"04.3", central_projection_scene},
                    {"04.4", perspective_scene},
                    {"04.5", look_at_scene},
                    {"04.6", pinhole_scene},
                    {"04.7", vertex_scene},
                    {"04.8", render_scene},
                    {"04.9", clip_scene},
                    {"04.10", normal_scene}});
}

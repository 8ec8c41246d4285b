// Exercises 04.3 to 04.6.
#include "common/lines/draw_line.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/central_projection.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/pinhole.h"
#include "common/projection/render.h"
#include "common/projection/rotation.h"
#include "common/projection/scene.h"
#include "common/projection/viewport.h"
#include "common/stage/given_files.h"
#include "common/viewer/camera.h"
#include "common/viewer/figure.h"

#include "04_projection/any_mesh.h"
#include "04_projection/figures.h"
#include "04_projection/text_of.h"

#include <limits>
#include <sstream>
#include <vector>

namespace rasterlab {

// --- 04.3 ---

namespace {
// In the course's frame the larger z is nearer: turned over for the depth buffer, and pressed
// together, so that nothing in front of the eye is beyond its limits.
Eigen::Matrix4f to_depth_buffer() {
  return scaling({1, 1, -0.25F});
}

void draw_at_distance(Run& run, const Mesh& mesh, float distance, const std::string& name) {
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.model =
      rotation(20, {1, 0, 0}) * rotation(30, {0, 1, 0}) * scaling({0.5F, 0.5F, 0.5F});
  transforms.projection = to_depth_buffer() * central_projection(distance);
  render_nearest(mesh, transforms, Cull::none, frame);
  run.picture("04.3_" + name, frame.color);
}

}  // namespace

void draw_from_distances(Run& run) {
  const Mesh cube = make_shape("cube");
  draw_at_distance(run, cube, 2, "distance_2");
  draw_at_distance(run, cube, 5, "distance_5");
  draw_at_distance(run, cube, std::numeric_limits<float>::infinity(), "infinitely_far");
  run.printout("04.3_matrix", text_of(central_projection(2)));
}

// --- 04.4 ---

void draw_in_perspective(Run& run) {
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

namespace {
void draw_looking_at(Run& run, const Eigen::Vector3f& center, const std::string& name) {
  Frame frame = frame_of(run);
  Transforms transforms;
  transforms.model = scaling({0.5F, 0.5F, 0.5F});
  transforms.view = look_at({1, 1, 2}, center, {0, 1, 0});
  transforms.projection = perspective(60, aspect_of(frame), 0.1F, 20);
  render_nearest(make_shape("cube"), transforms, Cull::none, frame);
  run.picture("04.5_" + name, frame.color);
}

}  // namespace

void draw_looking_at_things(Run& run) {
  draw_looking_at(run, {0, 0, 0}, "look_at");
  draw_looking_at(run, {-0.4F, 0.3F, 0}, "other_center");
  run.printout("04.5_matrices", text_of(look_at({1, 1, 2}, {0, 0, 0}, {0, 1, 0})) + "\n" +
                                    text_of(look_at({1, 1, 2}, {-0.4F, 0.3F, 0}, {0, 1, 0})));
}

// --- 04.6 ---

namespace {

// The edges of the mesh, their ends where project_points() puts them.
void draw_projected_edges(const Mesh& mesh, const std::vector<Eigen::Vector3f>& points,
                          Image<Rgb8>& image) {
  const auto pixel = [&](std::uint32_t vertex) -> Point {
    return points[vertex].head<2>().array().floor().cast<int>();
  };
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i];
      const std::uint32_t b = triangle[(i + 1) % 3];
      const bool in_front = points[a].z() > 0 && points[b].z() > 0;
      if (in_front) draw_line(image, pixel(a), pixel(b), Rgb8{255, 255, 255});
    }
  }
}

std::string table_of(const std::vector<Eigen::Vector3f>& positions,
                     const std::vector<Eigen::Vector3f>& points) {
  std::ostringstream text;
  text << "x y z: u v in pixels, depth\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text << positions[i].transpose() << ": " << points[i].transpose() << "\n";
  }
  return text.str();
}

}  // namespace

// The scene twice over: filled by the way of 04.7 and 04.8, and its edges by the pinhole camera.
// They must fall together.
void draw_through_a_pinhole(Run& run) {
  const Scene scene = read_scene(data_path("cube.scene"));
  const Mesh mesh = read_mesh(scene.mesh);
  const Size size = run.size({scene.width, scene.height});
  const Stand stand{bounding_box(mesh), mesh.positions, size};
  Frame frame = make_frame(size.width, size.height);
  render_nearest(mesh, transforms_of(make_camera(camera_of(scene), stand, 1), stand), Cull::none,
                 frame);
  run.picture("04.6_scene", frame.color);

  const float focal_length =
      scene.focal_length * static_cast<float>(size.height) / static_cast<float>(scene.height);
  const Eigen::Matrix4f camera = world_to_camera(scene.eye, scene.look_at, scene.up);
  const Eigen::Matrix3f k = calibration(focal_length, size.width, size.height);
  const std::vector<Eigen::Vector3f> points = project_points(mesh.positions, camera, k);
  draw_projected_edges(mesh, points, frame.color);
  run.picture("04.6_pinhole", frame.color);
  run.printout("04.6_points", "world to camera\n" + text_of(camera) + "K\n" + text_of(k) +
                                  table_of(mesh.positions, points));
}

}  // namespace rasterlab

#include "05_lighting/figures.h"

#include "common/image/animation.h"
#include "common/image/operations.h"
#include "common/lighting/facing.h"
#include "common/lighting/power_pictures.h"
#include "common/lighting/shading.h"
#include "common/lighting/turned_light.h"
#include "common/lighting/vertex_normals.h"
#include "common/lines/draw_line.h"
#include "common/mesh/normals.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/render.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"
#include "common/stage/given_files.h"
#include "common/viewer/figure.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rasterlab {
namespace {

const Color clay(0.85F, 0.45F, 0.3F);
constexpr Rgb8 dark{48, 48, 48};

// Over the camera's left shoulder, for a camera in front.
const Light from_upper_left{.position = {-0.5F, 0.7F, 1, 0}};

// From `eye` to the origin, 40° high.
Transforms seen_from(const Eigen::Vector3f& eye, const Frame& frame) {
  Transforms transforms;
  transforms.view = look_at(eye, {0, 0, 0}, {0, 1, 0});
  transforms.projection = perspective(40, aspect_of(frame), 0.1F, 20);
  return transforms;
}

// The bunny, its middle at the origin.
Mesh bunny() {
  Mesh mesh = read_mesh(bunny_path());
  const Eigen::Vector3f middle = bounding_box(mesh).center();
  for (Eigen::Vector3f& position : mesh.positions) position -= middle;
  mesh.normals = vertex_normals(mesh);
  return mesh;
}

// --- 05.1 ---

// A cube with eight vertices, so that each belongs to faces of all directions around it.
Mesh cube_of_eight_vertices() {
  Mesh cube;
  for (const float z : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float x : {-1.0F, 1.0F}) cube.positions.emplace_back(x, y, z);
    }
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  cube.colors.assign(8, Color::Constant(0.25F));
  return cube;
}

void draw_normals_as_lines(const Mesh& mesh, const std::vector<Eigen::Vector3f>& normals,
                           const Transforms& transforms, const Rgb8& color, Frame& frame) {
  const auto pixel = [&](const Eigen::Vector3f& position) -> Point {
    const Eigen::Vector4f clip = to_clip(transforms.to_clip(), position);
    return to_window(clip, frame.width(), frame.height()).position.array().floor().cast<int>();
  };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    draw_line(frame.color, pixel(mesh.positions[i]), pixel(mesh.positions[i] + 0.8F * normals[i]),
              color);
  }
}

// Red, green, blue for how far right, up and toward us a normal points.
void draw_normals_as_colors(Run& run, Mesh mesh, const std::vector<Eigen::Vector3f>& normals,
                            const std::string& name) {
  mesh.colors.clear();
  for (const Eigen::Vector3f& normal : normals) {
    mesh.colors.push_back((normal + Eigen::Vector3f::Ones()) / 2);
  }
  Frame frame = frame_of(run);
  render_nearest(mesh, seen_from({0, 0.4F, 3.9F}, frame), Cull::none, frame);
  run.picture("05.1_" + name, frame.color);
}

}  // namespace

void draw_vertex_normals(Run& run) {
  const Mesh cube = cube_of_eight_vertices();
  Frame frame = frame_of(run);
  const Transforms transforms = seen_from({1.5F, 1.9F, 6.4F}, frame);
  render_nearest(cube, transforms, Cull::none, frame);
  draw_normals_as_lines(cube, angle_weighted_normals(cube), transforms, {64, 255, 64}, frame);
  draw_normals_as_lines(cube, vertex_normals(cube), transforms, {255, 64, 64}, frame);
  run.picture("05.1_cube", frame.color);

  const Mesh mesh = bunny();
  draw_normals_as_colors(run, mesh, vertex_normals(mesh), "bunny_mean");
  draw_normals_as_colors(run, mesh, angle_weighted_normals(mesh), "bunny_angle_weighted");
}

// --- 05.2 ---

namespace {

Image<Rgb8> lit_ball(const Material& material, Frame frame, const Color& color) {
  const Mesh ball = make_shape("uv_sphere", 48);
  shade_gouraud({.mesh = ball,
                 .transforms = seen_from({0, 0, 3.2F}, frame),
                 .light = from_upper_left,
                 .material = material,
                 .color = color},
                frame);
  return frame.color;
}

}  // namespace

void draw_phong_parts(Run& run) {
  const Material course;  // Ka 0.2, Kd 0.8, Ks 0.6, exponent 128
  Material ambient = course;
  ambient.diffuse = ambient.specular = 0;
  Material diffuse = course;
  diffuse.ambient = diffuse.specular = 0;
  Material specular = course;
  specular.ambient = specular.diffuse = 0;
  const Frame frame = frame_of(run, {120, 120});
  run.picture("05.2_ambient", lit_ball(ambient, frame, clay));
  run.picture("05.2_diffuse", lit_ball(diffuse, frame, clay));
  run.picture("05.2_specular", lit_ball(specular, frame, clay));
  run.picture("05.2_sum", lit_ball(course, frame, clay));

  const Mesh mesh = bunny();
  Frame of_bunny = frame_of(run);
  shade_gouraud({.mesh = mesh,
                 .transforms = seen_from({0, 0.4F, 3.9F}, of_bunny),
                 .light = from_upper_left,
                 .material = course,
                 .color = clay},
                of_bunny);
  run.picture("05.2_bunny", of_bunny.color);
}

// --- 05.3: a floor under a lamp, and under the sun ---

void draw_blinn_phong(Run& run) {
  Mesh floor = make_shape("grid", 48);
  Frame frame = frame_of(run, {200, 140});
  LitMesh lit_mesh{
      .mesh = floor,
      .transforms = seen_from({0, 1.6F, 2.4F}, frame),
      .light = {.position = {0, 0.5F, 0, 1}},
      .material = {.ambient = 0.1F, .diffuse = 0.7F, .specular = 0.6F, .shininess = 32},
      .color = Color(0.4F, 0.6F, 0.9F),
      .model = ReflectionModel::blinn_phong};
  shade_phong(lit_mesh, frame);
  run.picture("05.3_point_light", frame.color);
  clear(frame);
  lit_mesh.light.position = {0, 0.5F, -0.5F, 0};
  shade_phong(lit_mesh, frame);
  run.picture("05.3_light_at_infinity", frame.color);
}

// --- 05.4 ---

void draw_lit_mesh(Run& run) {
  const Mesh mesh = bunny();
  Frame frame = frame_of(run, {280, 200});
  for (int i = 0; i < 3; ++i) {
    const std::array<Color, 3> colors = {Color(0.9F, 0.4F, 0.3F), Color(0.4F, 0.8F, 0.4F),
                                         Color(0.4F, 0.5F, 0.95F)};
    Transforms transforms = seen_from({0, 0.9F, 4}, frame);
    transforms.model = translation({1.2F * static_cast<float>(i - 1), 0, 0}) *
                       rotation(static_cast<float>(i) * 120, {0, 1, 0}) *
                       scaling({0.6F, 0.6F, 0.6F});
    shade_gouraud({.mesh = mesh,
                   .transforms = transforms,
                   .light = from_upper_left,
                   .material = {},
                   .color = colors[static_cast<std::size_t>(i)]},
                  frame);
  }
  run.picture("05.4_bunnies", frame.color);
}

// --- 05.5 ---

void draw_shading_ladder(Run& run) {
  const Mesh ball = make_shape("icosphere", 2);
  std::vector<Image<Rgb8>> pictures;
  for (const ShadingRung& rung : shading_ladder) {
    if (!run.draws(rung.name)) continue;
    Frame frame = frame_of(run, {160, 160});
    rung.shade({.mesh = ball,
                .transforms = seen_from({0.3F, 0.2F, 3.2F}, frame),
                .light = from_upper_left,
                .material = {.shininess = 40},
                .color = clay},
               frame);
    run.picture(std::string("05.5_") + rung.name, frame.color);
    pictures.push_back(frame.color);
  }
  if (!run.settings().algorithm.empty()) return;
  run.picture("05.5_side_by_side", side_by_side(pictures, 3, 2, dark));
}

// --- 05.6 ---

void draw_light_going_round(Run& run) {
  constexpr int frames = 100;
  const Mesh knot = make_shape("torus_knot", 12);
  const Light in_front{.position = {0, 0.3F, 1, 0}};
  Animation animation;
  for (int i = 0; i < frames; ++i) {
    const float angle = 360.0F * static_cast<float>(i) / frames;
    Frame frame = frame_of(run, {120, 120});
    shade_phong({.mesh = knot,
                 .transforms = seen_from({0, 0.6F, 3}, frame),
                 .light = turned_light(in_front, {0, 0, 0}, {0, 1, 0}, angle),
                 .material = {.shininess = 40},
                 .color = Color(0.95F, 0.75F, 0.3F)},
                frame);
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "05.6_light_%04d", i);
    run.picture(name.data(), frame.color);
    animation.add(frame.color);
    run.progress("05.6 frame", i + 1, frames);
  }
  run.file("05.6_light.png", [animation](const auto& path) { animation.write(path, 40); });
}

// --- 05.7: left out by which side is seen, and, as is easily got wrong, by which side is lit ---

namespace {

template <class Keep>
Mesh filtered(const Mesh& mesh, const Keep& keep) {
  Mesh kept = mesh;
  kept.triangles.clear();
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    if (keep(triangle)) kept.triangles.push_back(triangle);
  }
  return kept;
}

}  // namespace

void draw_culling(Run& run) {
  const Mesh ring = make_shape("torus", 32);
  const Light light{.position = {-1, 0.3F, 0.2F, 0}};
  const Frame empty = frame_of(run, {160, 120});
  const Transforms transforms = seen_from({0, 1.6F, 2.4F}, empty);
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  std::ostringstream text;
  const auto draw = [&](const std::string& name, const auto& keep) {
    const Mesh kept = filtered(ring, keep);
    Frame frame = empty;
    shade_flat(
        {.mesh = kept, .transforms = transforms, .light = light, .material = {}, .color = clay},
        frame);
    run.picture("05.7_" + name, frame.color);
    text << name << ": " << kept.triangles.size() << " of " << ring.triangles.size()
         << " triangles drawn\n";
  };
  const auto facing_of = [&](const Mesh::Triangle& triangle) {
    return facing({to_clip(to_clip_space, ring.positions[triangle[0]]),
                   to_clip(to_clip_space, ring.positions[triangle[1]]),
                   to_clip(to_clip_space, ring.positions[triangle[2]])},
                  transforms.mirrored());
  };
  draw("none_culled", [](const Mesh::Triangle&) { return true; });
  draw("back_culled", [&](const auto& triangle) { return facing_of(triangle) == Facing::front; });
  draw("front_culled", [&](const auto& triangle) { return facing_of(triangle) == Facing::back; });
  draw("culled_toward_the_light", [&](const Mesh::Triangle& triangle) {
    const Eigen::Vector3f& a = ring.positions[triangle[0]];
    const Eigen::Vector3f normal =
        (ring.positions[triangle[1]] - a).cross(ring.positions[triangle[2]] - a);
    return normal.dot(light.position.head<3>()) > 0;
  });
  run.printout("05.7_counts", text.str());
}

// --- 05.8: from power 0 at the left to 10, the highlight alone above the sum ---

void draw_specular_powers(Run& run) {
  const Mesh ball = make_shape("uv_sphere", 32);
  const Transforms transforms = seen_from({0, 0, 3.2F}, make_frame(64, 64));
  const LitMesh lit_ball_mesh{.mesh = ball,
                              .transforms = transforms,
                              .light = from_upper_left,
                              .material = {},
                              .color = clay};
  std::vector<Image<Rgb8>> highlights;
  std::vector<Image<Rgb8>> sums;
  for (int power = 0; power <= 10; ++power) {
    PowerPictures pictures = draw_power(lit_ball_mesh, static_cast<float>(power), 64, 64);
    highlights.push_back(std::move(pictures.highlight));
    sums.push_back(std::move(pictures.sum));
  }
  highlights.insert(highlights.end(), sums.begin(), sums.end());
  run.picture("05.8_powers", side_by_side(highlights, 11, 2, dark));
}

}  // namespace rasterlab

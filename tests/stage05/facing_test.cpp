#include "common/lighting/facing.h"

#include "common/mesh/shapes.h"
#include "common/projection/central_projection.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/eye.h"
#include "common/projection/look_at.h"
#include "common/projection/orthographic.h"
#include "common/projection/perspective.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;
using Corners = std::array<Vector, 3>;

Facing facing_of(const Corners& corners, const Transforms& transforms) {
  const Eigen::Matrix4f matrix = transforms.to_clip();
  return facing(
      {to_clip(matrix, corners[0]), to_clip(matrix, corners[1]), to_clip(matrix, corners[2])},
      transforms.mirrored());
}

// On which side of the triangle the eye is, in the world: > 0 in front. A mirror turns the way its
// corners go round.
double side_of_eye(const Corners& corners, const Transforms& transforms) {
  std::array<Eigen::Vector3d, 3> world;
  for (std::size_t i = 0; i < 3; ++i) {
    world[i] = (transforms.model * corners[i].homogeneous()).head<3>().cast<double>();
  }
  const Eigen::Vector3d normal = (world[1] - world[0]).cross(world[2] - world[0]).normalized();
  const Eigen::Vector4d eye = eye_of(transforms).cast<double>();
  const Eigen::Vector3d to_eye = eye.head<3>() - eye.w() * world[0];
  return normal.dot(to_eye) * (transforms.model.topLeftCorner<3, 3>().determinant() < 0 ? -1 : 1);
}

std::vector<Transforms> cameras() {
  std::vector<Transforms> all;
  Transforms transforms;
  transforms.view = look_at({1, 0.7F, 2.5F}, {0.1F, 0, 0}, {0.2F, 1, 0});
  for (const Eigen::Matrix4f& projection :
       {perspective(60, 1.5F, 0.1F, 20), perspective(120, 1, 0.1F, 20),
        orthographic(3, 1, -9, 9)}) {
    transforms.projection = projection;
    for (const Eigen::Matrix4f& model :
         {Eigen::Matrix4f::Identity().eval(), scaling({-1, 1, 1}), scaling({-1, -2, -0.5F}),
          Eigen::Matrix4f(rotation(70, {1, 2, 0}) * scaling({0.4F, 1, 1.5F}))}) {
      transforms.model = model;
      all.push_back(transforms);
    }
  }
  return all;
}

TEST(stage05_facing, is_the_side_of_the_triangle_the_eye_is_on_in_any_projection_and_mirror) {
  std::mt19937 engine(57);
  std::uniform_real_distribution<float> coordinate(-3, 3);  // many reach behind the eye
  const auto corner = [&] {
    const float x = coordinate(engine);
    const float y = coordinate(engine);
    return Vector(x, y, coordinate(engine));
  };
  for (const Transforms& transforms : cameras()) {
    for (int i = 0; i < 2000; ++i) {
      const Corners corners = {corner(), corner(), corner()};
      const double side = side_of_eye(corners, transforms);
      if (std::abs(side) < 1e-3) continue;
      ASSERT_EQ(facing_of(corners, transforms), side > 0 ? Facing::front : Facing::back);
    }
  }
}

TEST(stage05_facing, turned_a_little_away_from_the_axis_may_still_be_seen_in_perspective) {
  // To the right of the eye at the origin, facing left, its normal leaning away from the viewer by
  // 5°.
  const float lean = std::tan(5 * 3.14159265F / 180);
  const Corners corners = {Vector(2, -1, -3), Vector(2 - lean, -1, -2), Vector(2 - lean, 1, -2)};
  Transforms transforms;
  transforms.projection = perspective(90, 1, 0.1F, 20);
  const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  ASSERT_NE(side_of_eye(corners, transforms) > 0, normal.z() > 0)
      << "the test is about the difference between the two";
  EXPECT_EQ(facing_of(corners, transforms), Facing::front);
}

TEST(stage05_facing, without_area_or_through_the_eye_is_edge_on) {
  Transforms transforms;
  transforms.projection = perspective(90, 1, 0.1F, 20);
  EXPECT_EQ(facing_of({Vector(0, 0, -2), Vector(1, 0, -2), Vector(2, 0, -2)}, transforms),
            Facing::edge_on);
  EXPECT_EQ(facing_of({Vector(1, 0, -2), Vector(1, 0, -2), Vector(0, 1, -2)}, transforms),
            Facing::edge_on);
  EXPECT_EQ(facing_of({Vector(0, -1, -2), Vector(0, 1, -2), Vector(0, 0, -5)}, transforms),
            Facing::edge_on)
      << "the plane x = 0 goes through the eye";
}

TEST(stage05_facing, the_front_is_counter_clockwise) {
  EXPECT_EQ(facing({Eigen::Vector4f(0, 0, 0, 1), Eigen::Vector4f(1, 0, 0, 1),
                    Eigen::Vector4f(0, 1, 0, 1)},
                   false),
            Facing::front);
  EXPECT_EQ(facing({Eigen::Vector4f(0, 0, 0, 1), Eigen::Vector4f(1, 0, 0, 1),
                    Eigen::Vector4f(0, 1, 0, 1)},
                   true),
            Facing::back)
      << "in a mirror it goes the other way";
}

// Whether the rendering loop, which goes by the exact area of the snapped triangle, leaves it out
// as a back face; and how thin it is in the window, in pixels.
struct InWindow {
  bool culled;
  double thickness;
};

InWindow in_window(const Corners& corners, const Transforms& transforms) {
  Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  mesh.triangles = {{0, 1, 2}};
  Frame frame = make_frame(60, 40);
  const DrawCounts counts =
      draw_mesh(mesh, transforms, Cull::back, frame,
                [](std::uint32_t, const TrianglePixel&) { return Color(1, 1, 1); });
  std::array<Eigen::Vector2d, 3> window;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector4f clip = to_clip(transforms.to_clip(), corners[i]);
    window[i] = to_window(clip, 60, 40).position.cast<double>();
  }
  const Eigen::Vector2d ab = window[1] - window[0];
  const Eigen::Vector2d ac = window[2] - window[0];
  const double longest = std::max({ab.norm(), ac.norm(), (window[2] - window[1]).norm()});
  return {counts.culled > 0, std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / longest};
}

TEST(stage05_facing, is_the_sign_of_the_area_in_the_window_but_for_slivers_that_snapping_turns) {
  int slivers = 0;
  for (const char* name : {"cube:2", "torus:12", "icosphere:2"}) {
    const Mesh mesh = make_shape(name);
    for (const Transforms& transforms : cameras()) {
      for (const auto& [a, b, c] : mesh.triangles) {
        const Corners corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
        const InWindow seen = in_window(corners, transforms);
        const bool is_back = facing_of(corners, transforms) == Facing::back;
        if (seen.culled == is_back) continue;
        ASSERT_LT(seen.thickness, 1.0 / 128) << name << " " << a << " " << b << " " << c;
        ++slivers;
      }
    }
  }
  EXPECT_LT(slivers, 100);
}

Frame drawn(const Mesh& mesh, const Transforms& transforms, Cull cull) {
  Frame frame = make_frame(60, 40);
  draw_mesh(mesh, transforms, cull, frame,
            [](std::uint32_t, const TrianglePixel&) { return Color(1, 1, 1); });
  return frame;
}

TEST(stage05_facing, leaving_out_back_faces_takes_no_pixel_from_a_closed_mesh) {
  for (const char* name : {"cube:2", "torus:12", "icosphere:2"}) {
    const Mesh mesh = make_shape(name);
    for (const Transforms& transforms : cameras()) {
      const Frame all = drawn(mesh, transforms, Cull::none);
      EXPECT_EQ(drawn(mesh, transforms, Cull::back).color, all.color) << name;
      EXPECT_EQ(drawn(mesh, transforms, Cull::front).color, all.color) << name;
    }
  }
}

}  // namespace
}  // namespace rasterlab

#include "common/shaders/draw_shaded.h"

#include "common/projection/eye.h"
#include "common/projection/viewport.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"

#include <cmath>
#include <map>
#include <set>

#include <Eigen/LU>
#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int side = 72;

Frame empty_frame() {
  Frame frame = make_frame(side, side);
  frame.ids = Image<std::int32_t>(side, side, -1);
  return frame;
}

/// A shader that counts how it is called, and whose varying says which corner is which.
struct Recorder {
  template <class Number>
  struct Varyings {
    Number triangle;
    Vector3<Number> corner;
  };

  std::map<std::uint32_t, std::multiset<int>>* corners;
  std::map<int, int>* fragments;

  Varyings<float> vertex(const Mesh&, std::uint32_t triangle, int corner) const {
    (*corners)[triangle].insert(corner);
    return {static_cast<float>(triangle), Eigen::Vector3f::Unit(corner)};
  }
  Vector3<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    ++(*fragments)[static_cast<int>(std::lround(point.value.triangle))];
    return {1, 1, 1};
  }
};

TEST(stage07_draw_shaded, asks_for_the_corners_of_seen_triangles_and_for_their_pixels) {
  Mesh mesh = make_shape("uv_sphere:6");
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  mesh.triangles.push_back({0, 0, 1});  // without area
  std::map<std::uint32_t, std::multiset<int>> corners;
  std::map<int, int> fragments;
  Frame frame = empty_frame();
  const DrawCounts counts =
      draw_shaded(mesh, TestScene::transforms(), Cull::back, Recorder{&corners, &fragments}, frame);
  std::int64_t shaded = 0;
  for (const auto& [triangle, pixels] : fragments) {
    shaded += pixels;
    EXPECT_THAT(corners[static_cast<std::uint32_t>(triangle)], testing::ElementsAre(0, 1, 2))
        << "vertex() of triangle " << triangle << " is called once for each corner";
  }
  EXPECT_EQ(shaded, counts.pixels - counts.hidden) << "fragment() is called for each nearer pixel";
  EXPECT_EQ(corners.size(), fragments.size()) << "vertex() was called for triangles no one sees";
  EXPECT_EQ(counts.triangles, count + 1);
  std::set<int> seen;
  for (const std::int32_t face : frame.ids.pixels()) {
    if (face >= 0) seen.insert(face);
  }
  for (const int face : seen) EXPECT_GT(fragments[face], 0) << "triangle " << face;
}

/// Where the ray through a window point meets the plane z = 0 of the world, in double precision.
Eigen::Vector3d on_wall(const Transforms& transforms, double x, double y) {
  const Eigen::Matrix4d to_world =
      (transforms.projection.cast<double>() * transforms.view.cast<double>()).inverse();
  const auto unproject = [&](double z) -> Eigen::Vector3d {
    return (to_world * Eigen::Vector4d(2 * x / side - 1, 1 - 2 * y / side, z, 1)).hnormalized();
  };
  const Eigen::Vector3d near = unproject(-1);
  const Eigen::Vector3d far = unproject(1);
  return near + (far - near) * (near.z() / (near.z() - far.z()));
}

/// Keeps what fragment() is given, by pixel: drawn one triangle at a time, x and y come from where
/// the point is.
struct Point {
  Eigen::Vector3f position;
  Eigen::Vector3f dx;
  Eigen::Vector3f dy;
  bool front_facing;
};
struct KeepPoints {
  template <class Number>
  struct Varyings {
    Vector3<Number> position;
  };
  std::vector<Point>* points;

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {mesh.positions[mesh.triangles[triangle][static_cast<std::size_t>(corner)]]};
  }
  Vector3<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    points->push_back(
        {point.value.position, point.dx.position, point.dy.position, point.front_facing});
    return {1, 1, 1};
  }
};

TEST(stage07_draw_shaded, varyings_are_those_of_the_point_under_the_pixel) {
  const Mesh wall = make_shape("wall:3");
  const Transforms transforms = TestScene::transforms();
  std::vector<Point> points;
  Frame frame = empty_frame();
  draw_shaded(wall, transforms, Cull::none, KeepPoints{&points}, frame);
  ASSERT_GT(points.size(), 1000U);
  const Eigen::Matrix4d to_clip = transforms.to_clip().cast<double>();
  for (const Point& point : points) {
    const Eigen::Vector4d clip = to_clip * point.position.cast<double>().homogeneous();
    const double x = (clip.x() / clip.w() + 1) * side / 2;
    const double y = (1 - clip.y() / clip.w()) * side / 2;
    const double column = std::floor(x);
    const double row = std::floor(y);
    // Corners are snapped to 1/256 pixel, which moves the middle of a pixel by so much.
    EXPECT_NEAR(x - column, 0.5, 1.0 / 200) << "x = " << x << " is not the middle of a pixel";
    EXPECT_NEAR(y - row, 0.5, 1.0 / 200) << "y = " << y << " is not the middle of a pixel";
    const double step = 1e-3;
    const Eigen::Vector3d dx =
        (on_wall(transforms, x + step, y) - on_wall(transforms, x - step, y)) / (2 * step);
    const Eigen::Vector3d dy =
        (on_wall(transforms, x, y + step) - on_wall(transforms, x, y - step)) / (2 * step);
    EXPECT_LE((point.dx.cast<double>() - dx).norm(), 3e-3 * dx.norm()) << "∂position/∂x";
    EXPECT_LE((point.dy.cast<double>() - dy).norm(), 3e-3 * dy.norm()) << "∂position/∂y";
    EXPECT_TRUE(point.front_facing);
  }
}

TEST(stage07_draw_shaded, fragments_know_which_side_is_seen) {
  const Mesh wall = make_shape("wall:1");
  Transforms transforms = TestScene::transforms();
  for (const bool mirrored : {false, true}) {
    for (const float z : {2.6F, -2.6F}) {
      transforms.view = look_at({0.7F, 0.9F, z}, {0, 0, 0}, {0, 1, 0});
      transforms.model = scaling({mirrored ? -1.0F : 1.0F, 1, 1});
      std::vector<Point> points;
      Frame frame = empty_frame();
      draw_shaded(wall, transforms, Cull::none, KeepPoints{&points}, frame);
      ASSERT_GT(points.size(), 1000U);
      for (const Point& point : points) {
        ASSERT_EQ(point.front_facing, z > 0) << "seen from " << (z > 0 ? "the front" : "behind")
                                             << (mirrored ? ", the model mirrored" : "");
      }
    }
  }
}

/// Plain scalar code: refuses every second column of the wall, wherever it is.
struct Stripes {
  template <class Number>
  struct Varyings {
    Number along;
  };
  Color color;

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {mesh.positions[mesh.triangles[triangle][static_cast<std::size_t>(corner)]].x()};
  }
  Fragment<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    const int stripe = static_cast<int>(std::floor(point.value.along * 4));
    return {color, stripe % 2 == 0};
  }
};

Mesh wall_at(float z) {
  Mesh mesh = make_shape("wall:1");
  for (Eigen::Vector3f& position : mesh.positions) position.z() = z;
  return mesh;
}

constexpr Rgb8 red{255, 0, 0};
constexpr Rgb8 green{0, 255, 0};

TEST(stage07_draw_shaded, a_discarded_pixel_keeps_its_color_and_its_depth) {
  const Mesh near = wall_at(0.3F);
  const Mesh far = wall_at(-0.3F);
  const Transforms transforms = {.view = look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}),
                                 .projection = perspective(45, 1, 0.1F, 20)};
  Frame near_first = empty_frame();
  const DrawCounts counts =
      draw_shaded(near, transforms, Cull::none, Stripes{Color(1, 0, 0)}, near_first);
  EXPECT_GT(counts.discarded, 500);
  for (std::size_t i = 0; i < near_first.ids.pixels().size(); ++i) {
    const bool drawn = near_first.color.pixels()[i] == red;
    EXPECT_EQ(drawn, near_first.ids.pixels()[i] >= 0);
  }
  const Plain<ConstantColor> behind({.mesh = far, .color = Color(0, 1, 0)});
  draw_shaded(far, transforms, Cull::none, behind, near_first);
  Frame far_first = empty_frame();
  draw_shaded(far, transforms, Cull::none, behind, far_first);
  draw_shaded(near, transforms, Cull::none, Stripes{Color(1, 0, 0)}, far_first);
  EXPECT_TRUE(near_first.color == far_first.color)
      << "what is behind a hole is seen whatever was drawn first: a refused pixel has left its "
         "depth";
  const auto of = [](const Image<Rgb8>& image, const Rgb8& color) {
    return std::count(image.pixels().begin(), image.pixels().end(), color);
  };
  EXPECT_GT(of(near_first.color, red), 500);
  EXPECT_GT(of(near_first.color, green), 500);
}

TEST(stage07_draw_shaded, the_nearer_wins_in_any_order) {
  const Transforms transforms = TestScene::transforms();
  const Mesh near = wall_at(0.3F);
  const Mesh far = wall_at(-0.3F);
  const Plain<ConstantColor> in_front({.mesh = near, .color = Color(1, 0, 0)});
  const Plain<ConstantColor> behind({.mesh = far, .color = Color(0, 1, 0)});
  Frame a = empty_frame();
  draw_shaded(near, transforms, Cull::none, in_front, a);
  draw_shaded(far, transforms, Cull::none, behind, a);
  Frame b = empty_frame();
  draw_shaded(far, transforms, Cull::none, behind, b);
  draw_shaded(near, transforms, Cull::none, in_front, b);
  EXPECT_TRUE(a.color == b.color);
}

TEST(stage07_draw_shaded, leaves_out_the_side_that_is_named) {
  const Mesh wall = make_shape("wall:1");
  const Plain<ConstantColor> shader({.mesh = wall});
  Transforms transforms = TestScene::transforms();
  for (const float z : {2.6F, -2.6F}) {
    transforms.view = look_at({0.7F, 0.9F, z}, {0, 0, 0}, {0, 1, 0});
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
      Frame frame = empty_frame();
      const bool is_culled = cull == (z > 0 ? Cull::front : Cull::back);
      EXPECT_EQ(draw_shaded(wall, transforms, cull, shader, frame).pixels == 0, is_culled);
    }
  }
}

TEST(stage07_draw_shaded, nothing_gives_nothing) {
  Frame frame = empty_frame();
  const Mesh none;
  const Plain<ConstantColor> shader({.mesh = none});
  const DrawCounts counts = draw_shaded(none, TestScene::transforms(), Cull::none, shader, frame);
  EXPECT_EQ(counts.triangles, 0);
  EXPECT_TRUE(frame.color == empty_frame().color);
}

}  // namespace
}  // namespace rasterlab

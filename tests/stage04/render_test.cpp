#include "common/projection/render.h"

#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "tests/support/picture_text.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr Rgb8 red{255, 0, 0};
constexpr Rgb8 green{0, 255, 0};
constexpr Rgb8 blue{0, 0, 255};
constexpr Rgb8 yellow{255, 255, 0};

// A square of side 2 across the view, its corners red (top left), green (top right), blue (bottom
// left) and yellow (bottom right), each corner's colour in a quarter of its own.
Mesh four_corners() {
  Mesh mesh;
  const auto add = [&](float left, float bottom, const Rgb8& color) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}) {
      mesh.positions.emplace_back(left + x, bottom + y, 0);
      mesh.colors.push_back(to_color(color));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  };
  add(-1, 0, red);
  add(0, 0, green);
  add(-1, -1, blue);
  add(0, -1, yellow);
  return mesh;
}

Transforms seen_from(const Eigen::Vector3f& eye, float fovy = 90) {
  Transforms transforms;
  transforms.view = look_at(eye, {0, 0, 0}, {0, 1, 0});
  transforms.projection = perspective(fovy, 1, 0.1F, 100);
  return transforms;
}

void expect_corners(const Image<Rgb8>& image) {
  const int last = image.width() - 1;
  EXPECT_EQ(image(0, 0), red) << "top left";
  EXPECT_EQ(image(last, 0), green) << "top right";
  EXPECT_EQ(image(0, last), blue) << "bottom left";
  EXPECT_EQ(image(last, last), yellow) << "bottom right";
}

TEST(stage04_render_nearest, four_coloured_corners_are_where_they_belong) {
  Frame frame = make_frame(32, 32);
  render_nearest(four_corners(), seen_from({0, 0, 1}), Cull::none, frame);
  expect_corners(frame.color);
  Image<Rgb8> in_order(32, 32);
  render_in_order(four_corners(), seen_from({0, 0, 1}), in_order);
  expect_corners(in_order);
}

TEST(stage04_render_nearest, the_nearest_face_stays_whatever_the_order) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0},    {1, -1, 0},    {0, 1, 0},
                    {-1, -1, 0.5F}, {1, -1, 0.5F}, {0, 1, 0.5F}};
  mesh.colors = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  for (const bool near_first : {false, true}) {
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    if (near_first) std::swap(mesh.triangles[0], mesh.triangles[1]);
    Frame frame = make_frame(16, 16);
    render_nearest(mesh, seen_from({0, 0, 2}), Cull::none, frame);
    EXPECT_EQ(frame.color(8, 8), green);
    Image<Rgb8> in_order(16, 16);
    render_in_order(mesh, seen_from({0, 0, 2}), in_order);
    EXPECT_EQ(in_order(8, 8), near_first ? red : green) << "the last one drawn";
  }
}

TEST(stage04_render_nearest, of_two_equally_near_the_earlier_stays) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.colors = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  Frame frame = make_frame(16, 16);
  const DrawCounts counts = render_nearest(mesh, seen_from({0, 0, 2}), Cull::none, frame);
  EXPECT_EQ(frame.color(8, 8), red);
  EXPECT_EQ(counts.hidden, counts.pixels / 2);
}

TEST(stage04_render_nearest, colours_are_interpolated_in_space_not_in_the_window) {
  // A strip that leads away, black at the near end (z = 4, distance 1), white at the far one
  // (z = −4, distance 9).
  Mesh strip;
  strip.positions = {{-9, -1, 4}, {9, -1, 4}, {9, -1, -4}, {-9, -1, -4}};
  strip.colors = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};
  strip.triangles = {{0, 1, 2}, {0, 2, 3}};
  Transforms transforms;
  transforms.view = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  transforms.projection = perspective(90, 1, 0.1F, 100);
  Frame frame = make_frame(64, 64);
  render_nearest(strip, transforms, Cull::none, frame);
  for (int y = 36; y < 64; ++y) {
    const double distance = 1 / ((y + 0.5) / 32 - 1);  // where the line of sight meets y = −1
    const double expected = (distance - 1) / 8 * 255;
    EXPECT_NEAR(frame.color(32, y).r, expected, 1) << "row " << y;
  }
}

TEST(stage04_render_nearest, a_mesh_without_colours_is_white) {
  Mesh mesh = four_corners();
  mesh.colors.clear();
  Frame frame = make_frame(8, 8);
  render_nearest(mesh, seen_from({0, 0, 1}), Cull::none, frame);
  EXPECT_EQ(frame.color, Image<Rgb8>(8, 8, Rgb8{255, 255, 255}));
}

TEST(stage04_render_nearest, from_inside_a_mesh_nothing_wraps_round) {
  // Inside the cube, looking at its face x = 1, whose corners have red 1: nothing of the face
  // behind may show.
  Transforms transforms;
  transforms.view = look_at({0.5F, 0.1F, -0.2F}, {1, 0.1F, -0.2F}, {0, 1, 0});
  transforms.projection = perspective(60, 1, 0.01F, 100);
  Frame frame = make_frame(32, 32);
  frame.distance = Image<float>(32, 32);
  clear(frame);
  render_nearest(make_shape("cube", 1), transforms, Cull::none, frame);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      ASSERT_EQ(frame.color(x, y).r, 255) << x << ", " << y;
      ASSERT_NEAR(frame.distance(x, y), 0.5F, 1e-5F) << "along the view axis";
    }
  }
}

TEST(stage04_render_nearest, distances_and_ids_where_something_was_drawn) {
  Frame frame = make_frame(32, 32);
  frame.distance = Image<float>(32, 32);
  frame.ids = Image<std::int32_t>(32, 32);
  clear(frame);
  render_nearest(four_corners(), seen_from({0, 0, 2}), Cull::none, frame);
  EXPECT_EQ(frame.ids(0, 0), -1);
  EXPECT_EQ(frame.distance(0, 0), std::numeric_limits<float>::infinity());
  EXPECT_EQ(frame.ids(12, 10), 0 + 1) << "in the upper left square, above its diagonal";
  EXPECT_FLOAT_EQ(frame.distance(12, 10), 2);
}

TEST(stage04_render_nearest, an_empty_mesh_leaves_the_picture_as_it_was) {
  Frame frame = make_frame(4, 4);
  render_nearest(Mesh(), seen_from({0, 0, 2}), Cull::none, frame);
  EXPECT_EQ(frame.color, Image<Rgb8>(4, 4));
}

TEST(stage04_render_wireframe, a_square_shows_its_sides_and_its_diagonal) {
  Mesh square;
  square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  Image<Rgb8> image(8, 8);
  render_wireframe(square, seen_from({0, 0, 1}), Color::Ones(), image);
  EXPECT_TRUE(covers_exactly(image, {
                                        "########",
                                        "#.....##",
                                        "#....#.#",
                                        "#...#..#",
                                        "#..#...#",
                                        "#.#....#",
                                        "##.....#",
                                        "########",
                                    }));
}

TEST(stage04_render_wireframe, an_edge_that_goes_behind_the_eye_is_cut_not_wrapped) {
  // From the middle of the picture's lower half straight back over the eye's head... below it.
  Mesh edge;
  edge.positions = {{0, -1, -2}, {0, -1, 3}, {0, -1, 3}};
  edge.triangles = {{0, 1, 2}};
  Transforms transforms;
  transforms.projection = perspective(90, 1, 0.1F, 100);
  Image<Rgb8> image(8, 8);
  render_wireframe(edge, transforms, Color::Ones(), image);
  EXPECT_TRUE(covers_exactly(image, {
                                        "........",
                                        "........",
                                        "........",
                                        "........",
                                        "........",
                                        "........",
                                        "....#...",
                                        "....#...",
                                    }));
}

TEST(stage04_render_wireframe, corners_that_are_no_numbers_do_no_harm) {
  Mesh mesh = four_corners();
  mesh.positions[0].x() = std::numeric_limits<float>::quiet_NaN();
  mesh.positions[5].y() = std::numeric_limits<float>::infinity();
  Image<Rgb8> image(8, 8);
  EXPECT_NO_THROW(render_wireframe(mesh, seen_from({0, 0, 2}), Color::Ones(), image));
}

}  // namespace
}  // namespace rasterlab

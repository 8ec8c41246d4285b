// The fills of exercises 02.1, 02.3 and 02.4.
#include "common/triangles/barycentric.h"
#include "common/triangles/draw_triangle_wireframe.h"
#include "common/triangles/fill_edge_functions.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fill_scanline.h"
#include "common/triangles/fill_spans.h"
#include "common/triangles/fill_triangle_gradient.h"
#include "common/triangles/fill_triangle_list.h"

#include "tests/oracle/exact_segment.h"
#include "tests/oracle/exact_triangle.h"
#include "tests/support/picture_text.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr Rgb8 white{255, 255, 255};
using PixelTriangle = std::array<Point, 3>;

PictureText filled(FillTriangle fill, const Corners& corners, int width, int height) {
  Image<Rgb8> image(width, height);
  fill(image, corners, white);
  return picture_text(image);
}

PictureText exact(const Corners& corners, int width, int height) {
  return picture_text(oracle::coverage({oracle::to_grid(corners)}, width, height));
}

/// A corner on a grid of 1/units pixel.
Eigen::Vector2d random_corner(std::mt19937& random, int low, int high, int units) {
  std::uniform_int_distribution<int> place(low * units, high * units);
  const double x = place(random);
  return {x / units, static_cast<double>(place(random)) / units};
}

Corners random_corners(std::mt19937& random, int low, int high, int units) {
  return {random_corner(random, low, high, units), random_corner(random, low, high, units),
          random_corner(random, low, high, units)};
}

// 02.1

TEST(stage02_draw_triangle_wireframe, small) {
  Image<Rgb8> image(7, 5);
  draw_triangle_wireframe(image, {{{0, 0}, {4, 4}, {0, 4}}}, white);
  EXPECT_TRUE(covers_exactly(image, {"#......", "##.....", "#.#....", "#..#...", "#####.."}))
      << "three sides, corners included, and nothing inside";
}

TEST(stage02_draw_triangle_wireframe, any_order_has_all_sides) {
  PixelTriangle corners = {{{1, 1}, {1, 5}, {5, 5}}};
  std::sort(corners.begin(), corners.end(),
            [](const Point& a, const Point& b) { return a.x() * 9 + a.y() < b.x() * 9 + b.y(); });
  for (int i = 0; i < 3; ++i) {
    Image<Rgb8> image(7, 7);
    draw_triangle_wireframe(image, corners, white);
    EXPECT_TRUE(covers_exactly(
        image, {".......", ".#.....", ".##....", ".#.#...", ".#..#..", ".#####.", "......."}));
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

TEST(stage02_draw_triangle_wireframe, degenerate) {
  Image<Rgb8> point(3, 3);
  draw_triangle_wireframe(point, {{{1, 1}, {1, 1}, {1, 1}}}, white);
  EXPECT_TRUE(covers_exactly(point, {"...", ".#.", "..."})) << "three equal corners are one pixel";
  Image<Rgb8> line(5, 1);
  draw_triangle_wireframe(line, {{{0, 0}, {2, 0}, {4, 0}}}, white);
  EXPECT_TRUE(covers_exactly(line, {"#####"})) << "collinear corners are a line";
}

TEST(stage02_draw_triangle_wireframe, outside_is_left_out) {
  Image<Rgb8> image(5, 5);
  draw_triangle_wireframe(image, {{{-1000000, 2}, {1000000, 2}, {2, 900000000}}}, white);
  EXPECT_EQ(picture_text(image)[2], "#####") << "the side that crosses the image is seen whole";
}

TEST(stage02_draw_triangle_wireframe, corners_too_far) {
  Image<Rgb8> image(4, 4);
  constexpr int far_away = 1 << 30;
  EXPECT_NO_THROW(
      draw_triangle_wireframe(image, {{{0, -far_away}, {far_away, 9}, {-far_away, 9}}}, white));
  EXPECT_THROW(draw_triangle_wireframe(image, {{{0, 0}, {1, 1}, {far_away + 1, 0}}}, white),
               CheckError);
}

// 02.3

TEST(stage02_fill_triangle, sides_and_inside) {
  Image<Rgb8> image(7, 5);
  fill_triangle(image, {{{0, 0}, {4, 4}, {0, 4}}}, white);
  EXPECT_TRUE(covers_exactly(image, {"#......", "##.....", "###....", "####...", "#####.."}));
}

TEST(stage02_fill_triangle, contains_its_wireframe_and_has_no_holes) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(-10, 40);
  for (int i = 0; i < 1200; ++i) {
    PixelTriangle corners;
    for (Point& corner : corners) corner = {place(random), place(random)};
    // Where two pixels are equally near, a scanline may have the one and a line the other.
    const auto side_has_ties = [&](std::size_t k) {
      return oracle::ExactSegment(corners[k], corners[(k + 1) % 3]).has_ties();
    };
    if (side_has_ties(0) || side_has_ties(1) || side_has_ties(2)) continue;
    Image<Rgb8> sides(30, 30);
    draw_triangle_wireframe(sides, corners, white);
    Image<Rgb8> fill(30, 30);
    fill_triangle(fill, corners, white);
    for (int y = 0; y < 30; ++y) {
      const std::string row = picture_text(fill)[static_cast<std::size_t>(y)];
      const std::size_t first = row.find('#');
      const std::size_t last = row.rfind('#');
      if (first == std::string::npos) continue;
      ASSERT_EQ(row.find('.', first) < last, false) << "a hole in row " << y;
    }
    for (std::size_t k = 0; k < fill.pixels().size(); ++k) {
      if (!(sides.pixels()[k] == white)) continue;
      ASSERT_EQ(fill.pixels()[k], white) << "a pixel of a side is missing";
    }
  }
}

TEST(stage02_fill_triangle, one_pixel_and_lines) {
  Image<Rgb8> point(3, 3);
  fill_triangle(point, {{{1, 1}, {1, 1}, {1, 1}}}, white);
  EXPECT_TRUE(covers_exactly(point, {"...", ".#.", "..."}));
  Image<Rgb8> column(3, 3);
  fill_triangle(column, {{{1, 0}, {1, 2}, {1, 1}}}, white);
  EXPECT_TRUE(covers_exactly(column, {".#.", ".#.", ".#."}));
}

TEST(stage02_fill_triangle, far_outside) {
  Image<Rgb8> image(4, 4);
  constexpr int far_away = 1 << 30;
  fill_triangle(image, {{{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}}}, white);
  EXPECT_TRUE(covers_exactly(image, {"####", "####", "####", "####"})) << "the image is inside";
  EXPECT_THROW(fill_triangle(image, {{{0, 0}, {far_away + 1, 0}, {0, 1}}}, white), CheckError);
}

TEST(stage02_fill_triangle_gradient, corners_have_their_colours) {
  Image<Rgb8> image(40, 40);
  fill_triangle_gradient(image, {{{3, 5}, {35, 11}, {9, 37}}},
                         {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)});
  EXPECT_EQ(image(3, 5), (Rgb8{255, 0, 0}));
  EXPECT_EQ(image(35, 11), (Rgb8{0, 255, 0}));
  EXPECT_EQ(image(9, 37), (Rgb8{0, 0, 255}));
}

TEST(stage02_fill_triangle_gradient, same_pixels_as_one_colour) {
  const PixelTriangle corners = {{{-5, 5}, {35, 11}, {9, 57}}};
  Image<Rgb8> gradient(30, 40);
  fill_triangle_gradient(gradient, corners, {Color(1, 1, 1), Color(1, 1, 1), Color(1, 1, 1)});
  Image<Rgb8> plain(30, 40);
  fill_triangle(plain, corners, white);
  EXPECT_EQ(gradient, plain) << "three equal colours are one colour";
}

TEST(stage02_fill_triangle_gradient, one_pixel_and_lines) {
  const std::array<Color, 3> colors = {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)};
  Image<Rgb8> point(3, 3);
  fill_triangle_gradient(point, {{{1, 1}, {1, 1}, {1, 1}}}, colors);
  EXPECT_TRUE(covers_exactly(point, {"...", ".#.", "..."})) << "three equal corners are one pixel";
  for (const PixelTriangle& corners :
       {PixelTriangle{{{1, 0}, {1, 2}, {1, 1}}}, {{{1, 0}, {1, 0}, {1, 2}}}}) {
    Image<Rgb8> column(3, 3);
    fill_triangle_gradient(column, corners, colors);
    EXPECT_TRUE(covers_exactly(column, {".#.", ".#.", ".#."})) << "a flat triangle is a line";
  }
}

TEST(stage02_fill_triangle_gradient, far_outside) {
  Image<Rgb8> image(4, 4);
  constexpr int far_away = 1 << 30;
  const std::array<Color, 3> colors = {Color(1, 1, 1), Color(1, 1, 1), Color(1, 1, 1)};
  fill_triangle_gradient(image, {{{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}}},
                         colors);
  EXPECT_TRUE(covers_exactly(image, {"####", "####", "####", "####"})) << "the image is inside";
  EXPECT_THROW(fill_triangle_gradient(image, {{{0, 0}, {far_away + 1, 0}, {0, 1}}}, colors),
               CheckError);
}

TEST(stage02_fill_triangle_gradient, is_a_plane) {
  // Red grows by 1/32 with x, green by 1/32 with y: linear along every side and so everywhere.
  const PixelTriangle corners = {{{0, 0}, {32, 0}, {0, 32}}};
  Image<Rgb8> image(33, 33);
  fill_triangle_gradient(image, corners, {Color(0, 0, 0), Color(1, 0, 0), Color(0, 1, 0)});
  for (int y = 0; y <= 32; ++y) {
    for (int x = 0; x + y <= 32; ++x) {
      ASSERT_NEAR(image(x, y).r, 255.0 * x / 32, 1) << "red at (" << x << ", " << y << ")";
      ASSERT_NEAR(image(x, y).g, 255.0 * y / 32, 1) << "green at (" << x << ", " << y << ")";
    }
  }
}

// 02.4

TEST(stage02_barycentric, corners_middle_and_outside) {
  const Corners corners = {{{1, 1}, {9, 1}, {1, 5}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i));
    EXPECT_TRUE(barycentric(corners, corners[i]).isApprox(unit, 1e-12)) << "at corner " << i;
  }
  EXPECT_TRUE(barycentric(corners, {3, 2}).isApprox(Eigen::Vector3d(0.5, 0.25, 0.25), 1e-12));
  EXPECT_LT(barycentric(corners, {8, 4}).minCoeff(), 0) << "outside, a weight is negative";
}

TEST(stage02_barycentric, against_exact_weights_either_winding) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    Corners corners = random_corners(random, -50, 50, 256);
    const Eigen::Vector2d side = corners[1] - corners[0];
    const Eigen::Vector2d other = corners[2] - corners[0];
    if (std::abs(side.x() * other.y() - side.y() * other.x()) < 50) continue;
    const Eigen::Vector2d center(7.5, 11.5);
    for (int winding = 0; winding < 2; ++winding) {
      const Eigen::Vector3d weights = barycentric(corners, center);
      const auto truth = oracle::weights(oracle::to_grid(corners), 7, 11);
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(weights[static_cast<Eigen::Index>(k)], static_cast<double>(truth[k]), 1e-9)
            << "weight of corner " << k << "; the sign of the area must not matter";
      }
      std::swap(corners[1], corners[2]);
    }
  }
}

TEST(stage02_barycentric, without_area_is_outside) {
  const Corners line = {{{0, 0}, {2, 2}, {4, 4}}};
  EXPECT_EQ(barycentric(line, {1, 1}), Eigen::Vector3d(-1, -1, -1));
}

TEST(stage02_fill_edge_functions, centres_inside) {
  EXPECT_TRUE(
      same_picture(filled(&fill_edge_functions, {{{1, 1}, {6, 1}, {1, 6}}}, 7, 7),
                   {".......", ".####..", ".###...", ".##....", ".#.....", ".......", "......."}))
      << "the diagonal runs through centres and is a right edge: those belong to the neighbour";
}

TEST(stage02_fill_edge_functions, top_and_left_edges_own_their_centres) {
  // A square with its sides on pixel centres, cut along the diagonal.
  const Corners upper = {{{1.5, 1.5}, {4.5, 1.5}, {4.5, 4.5}}};
  const Corners lower = {{{1.5, 1.5}, {4.5, 4.5}, {1.5, 4.5}}};
  EXPECT_TRUE(same_picture(filled(&fill_edge_functions, upper, 6, 6),
                           {"......", ".###..", "..##..", "...#..", "......", "......"}))
      << "top side yes, right side no, diagonal (a left edge here) yes";
  EXPECT_TRUE(same_picture(filled(&fill_edge_functions, lower, 6, 6),
                           {"......", "......", ".#....", ".##...", "......", "......"}))
      << "left side yes, bottom side no, diagonal (a right edge here) no";
}

TEST(stage02_fill_edge_functions, equals_128_bit_integers) {
  std::mt19937 random(1);
  for (const int units : {1, 2, 8, 256, 1024}) {
    for (int i = 0; i < 1500; ++i) {
      const Corners corners = random_corners(random, -8, 24, units);
      ASSERT_TRUE(
          same_picture(filled(&fill_edge_functions, corners, 17, 13), exact(corners, 17, 13)))
          << corners[0].transpose() << " | " << corners[1].transpose() << " | "
          << corners[2].transpose();
    }
  }
}

TEST(stage02_fill_edge_functions, to_32768_pixels) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Corners corners = random_corners(random, -32768, 32768, i % 2 == 0 ? 256 : 1);
    ASSERT_TRUE(
        same_picture(filled(&fill_edge_functions, corners, 24, 24), exact(corners, 24, 24)));
  }
  Image<Rgb8> image(4, 4);
  EXPECT_THROW(fill_edge_functions(image, {{{0, 0}, {32768.5, 0}, {0, 1}}}, white), CheckError);
  EXPECT_THROW(fill_edge_functions(
                   image, {{{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1}}}, white),
               CheckError);
}

TEST(stage02_fill_edge_functions, slivers) {
  std::mt19937 random(9);
  for (int i = 0; i < 3000; ++i) {
    Corners corners = random_corners(random, 0, 24, 256);
    const double t = std::uniform_real_distribution<double>(-1, 2)(random);
    corners[2] = corners[0] + t * (corners[1] - corners[0]);
    corners[2] = (corners[2] * 256).array().round() / 256;
    corners[2].y() += std::uniform_int_distribution<int>(-2, 2)(random) / 256.0;
    ASSERT_TRUE(
        same_picture(filled(&fill_edge_functions, corners, 24, 24), exact(corners, 24, 24)));
  }
}

TEST(stage02_fill_edge_functions, zero_area_covers_nothing) {
  for (const Corners& corners :
       {Corners{{{0.5, 0.5}, {4.5, 4.5}, {2.5, 2.5}}}, Corners{{{1, 1}, {1, 1}, {5, 5}}},
        Corners{{{2.5, 2.5}, {2.5, 2.5}, {2.5, 2.5}}}, Corners{{{0, 2.5}, {6, 2.5}, {3, 2.5}}}}) {
    EXPECT_TRUE(
        same_picture(filled(&fill_edge_functions, corners, 6, 6), PictureText(6, "......")));
  }
}

TEST(stage02_fill_edge_functions, spans_draw_the_same) {
  std::mt19937 random(11);
  for (int i = 0; i < 4000; ++i) {
    const Corners corners = random_corners(random, i % 4 == 0 ? -30000 : -8,
                                           i % 4 == 0 ? 30000 : 40, i % 2 == 0 ? 256 : 2);
    const PictureText expected = filled(&fill_edge_functions, corners, 31, 23);
    for (const SpanFill& way : span_fills()) {
      Image<Rgb8> image(31, 23);
      const std::int64_t count = way.fill(image, corners, white);
      ASSERT_TRUE(same_picture(picture_text(image), expected)) << way.name;
      ASSERT_EQ(count, std::count(image.pixels().begin(), image.pixels().end(), white))
          << way.name << " says how many pixels it drew";
    }
  }
}

// Sides that are followed for many rows, and corners at the bounds of what the two ways of finding
// spans are for.
TEST(stage02_fill_spans, are_exact_out_to_their_bounds) {
  std::mt19937 random(12);
  std::int64_t covered = 0;
  for (const auto& [width, height] : {std::pair{9, 900}, {900, 9}, {61, 47}}) {
    for (const int reach : {40, 1000, 32768, 32769, 1 << 22, 1 << 30}) {
      const int units = reach > 1 << 22 ? 1 : 256;  // reach · units fits in an int
      for (int i = 0; i < 300; ++i) {
        Corners corners = random_corners(random, -reach, reach, units);
        if (i % 3 == 0) corners[2] = corners[1] + random_corner(random, -2, 2, 256);  // a sliver
        if (!within(corners, max_wide_coordinate)) continue;
        const PictureText expected = exact(corners, width, height);
        for (const SpanFill& way : span_fills()) {
          Image<Rgb8> image(width, height);
          covered += way.fill(image, corners, white);
          ASSERT_TRUE(same_picture(picture_text(image), expected))
              << way.name << ", corners " << corners[0].transpose() << " | "
              << corners[1].transpose() << " | " << corners[2].transpose();
        }
      }
    }
  }
  EXPECT_GT(covered, 1000000) << "too few triangles reach into the picture";
}

// Of two colours, so that a byte too many would show, and with rows of every length.
TEST(stage02_fill_spans, keep_what_is_beside_them) {
  for (const SpanFill& way : span_fills()) {
    for (int length = 0; length <= 70; ++length) {
      Image<Rgb8> image(80, 4, Rgb8{7, 8, 9});
      const Corners corners = {{{5, 1}, {5.0 + length, 1}, {5.0 + length, 2.75}}};
      way.fill(image, corners, Rgb8{10, 20, 30});
      Image<Rgb8> expected(80, 4, Rgb8{7, 8, 9});
      fill_edge_functions(expected, corners, Rgb8{10, 20, 30});
      ASSERT_EQ(image, expected) << way.name << ", " << length << " pixels wide";
    }
  }
}

TEST(stage02_fill_spans, refuse_corners_too_far) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SpanFill& way : span_fills()) {
    Image<Rgb8> image(4, 4);
    EXPECT_THROW(way.fill(image, {{{0, 0}, {0x1p30 + 1, 0}, {0, 4}}}, white), CheckError);
    EXPECT_THROW(way.fill(image, {{{0, 0}, {4, nan}, {0, 4}}}, white), CheckError);
  }
}

/// Checks that every way to fill a list sets exactly the pixels that the last rung sets triangle by
/// triangle, of a picture that differs everywhere, and counts what single calls count; also behind
/// many that are small, as the first ones may decide how a list is filled.
void expect_filled_as_one_by_one(const std::vector<Corners>& triangles, int width, int height) {
  const Rgb8 color{10, 20, 30};
  Image<Rgb8> before(width, height, Rgb8{7, 8, 9});
  for (std::size_t i = 0; i < before.pixels().size(); ++i)
    before.pixels()[i].g = static_cast<std::uint8_t>(i * 7);
  Image<Rgb8> expected = before;
  Image<Rgb8> by_single_calls = before;
  DrawnTriangles drawn;
  for (const Corners& corners : triangles) {
    fill_edge_functions(expected, corners, color);
    drawn.add(fill_spans(by_single_calls, corners, color));
  }
  std::vector<Corners> behind_small(64, {Eigen::Vector2d{1, 1}, {1, 1}, {1, 1}});
  behind_small.insert(behind_small.end(), triangles.begin(), triangles.end());
  for (const TriangleListWay& way : triangle_list_ways()) {
    for (const std::vector<Corners>& list : {triangles, behind_small}) {
      Image<Rgb8> image = before;
      EXPECT_TRUE(way.fill(image, list, color) == drawn) << way.name;
      EXPECT_TRUE(image == expected)
          << way.name << ", " << list.size() << " triangles, " << width << " x " << height;
    }
  }
}

/// A triangle no larger than `size` pixels somewhere around a width × height image; some without
/// area, some of them slivers, some with corners on pixel centres.
Corners random_small_corners(std::mt19937& random, int width, int height, int size) {
  const int units = random() % 4U == 0 ? 2 : 256;
  const auto up_to = [&random](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most + 1));
  };
  const Eigen::Vector2d place(up_to(width + size) - size, up_to(height + size) - size);
  Corners corners = random_corners(random, 0, size, units);
  const unsigned kind = random() % 16U;
  if (kind == 0) corners[2] = corners[1];
  if (kind == 1) corners[2] = (corners[0] + corners[1]) / 2;
  if (kind == 2) corners[2] = corners[1] + random_corner(random, -2, 2, 256) / 256;
  if (kind == 3) corners[2].y() = corners[1].y();
  if (kind == 4) corners[2].x() = corners[1].x();
  for (Eigen::Vector2d& corner : corners) corner += place;
  return corners;
}

TEST(stage02_fill_triangle_list, any_triangles_of_an_image) {
  constexpr std::array sizes = {2, 6, 10, 21, 22, 32, 33, 63, 64, 90};
  std::mt19937 random(13);
  for (const auto& [width, height] : {std::pair{1, 1}, {9, 7}, {70, 50}, {200, 3}, {3, 200}}) {
    for (std::size_t i = 0; i < 200; ++i) {
      std::vector<Corners> triangles;
      while (triangles.size() < i % 41) {
        const int size = sizes[random() % sizes.size()];
        triangles.push_back(random_small_corners(random, width, height, size));
      }
      expect_filled_as_one_by_one(triangles, width, height);
    }
  }
}

// One alone, so that no other covers what is wrong with it.
TEST(stage02_fill_triangle_list, one_small_triangle) {
  std::mt19937 random(14);
  for (int i = 0; i < 3000; ++i)
    expect_filled_as_one_by_one({random_small_corners(random, 12, 11, 2 + i % 9)}, 12, 11);
}

TEST(stage02_fill_triangle_list, rows_of_every_length) {
  for (int length = 0; length <= 70; ++length) {
    std::vector<Corners> triangles;
    for (int i = 0; i < 9; ++i)
      triangles.push_back({{{5, 3 * i + 1}, {5.0 + length, 3 * i + 1}, {5.0 + i, 3 * i + 3}}});
    expect_filled_as_one_by_one(triangles, 80, 30);
  }
}

// More rows than wait at once to be written.
TEST(stage02_fill_triangle_list, many_rows) {
  std::vector<Corners> triangles;
  for (int i = 0; i < 43; ++i) triangles.push_back({{{0, i}, {63, i + 1}, {i, i + 32}}});
  expect_filled_as_one_by_one(triangles, 60, 80);
}

TEST(stage02_fill_triangle_list, at_the_bounds_of_single_calls) {
  std::vector<Corners> triangles;
  for (const double far : {-32768.0, -32767.0, 32750.0, 32759.0}) {
    triangles.push_back({{{far, 0}, {far + 9, 1}, {far, 2}}});
    triangles.push_back({{{0, far}, {1, far + 9}, {2, far}}});
  }
  expect_filled_as_one_by_one(triangles, 20, 20);
  expect_filled_as_one_by_one(triangles, 32768, 2);
  expect_filled_as_one_by_one(triangles, 2, 32768);
  expect_filled_as_one_by_one(triangles, 0, 0);
}

TEST(stage02_fill_triangle_list, far_from_the_origin) {
  std::mt19937 random(15);
  constexpr int size = 20;
  constexpr int far = static_cast<int>(max_coordinate) - size;
  for (const auto& [width, height] : {std::pair{far, 2}, {2, far}}) {
    std::vector<Corners> triangles;
    while (triangles.size() < 2000)
      triangles.push_back(random_small_corners(random, width, height, size));
    expect_filled_as_one_by_one(triangles, width, height);
  }
}

TEST(stage02_fill_triangle_list, beyond_the_bounds_of_single_calls) {
  const std::vector<Corners> triangles = {{{{1, 1}, {0x1p30, 3}, {1, 9}}},
                                          {{{-40000, 2}, {12, 2}, {12, 40000}}},
                                          {{{32767, 2}, {32769, 0}, {32770, 40}}}};
  std::vector<oracle::GridTriangle> on_grid;
  for (const Corners& corners : triangles) on_grid.push_back(oracle::to_grid(corners));
  const Image<std::uint16_t> times = oracle::coverage(on_grid, 33000, 12);
  for (const TriangleListWay& way : triangle_list_ways()) {
    Image<Rgb8> image(33000, 12);
    EXPECT_EQ(way.fill(image, triangles, white).pixels,
              std::accumulate(times.pixels().begin(), times.pixels().end(), std::int64_t{0}))
        << way.name;
    EXPECT_TRUE(same_picture(picture_text(image), picture_text(times))) << way.name;
  }
}

TEST(stage02_fill_triangle_list, refuses_corners_too_far) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TriangleListWay& way : triangle_list_ways()) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (const int axis : {0, 1}) {
        for (const double value : {nan, 0x1p30 + 1, -0x1p30 - 1}) {
          std::vector<Corners> triangles(11, Corners{{{0, 0}, {4, 1}, {0, 4}}});
          triangles[corner * 4 + 1][corner][axis] = value;
          Image<Rgb8> image(4, 4);
          EXPECT_THROW(way.fill(image, triangles, white), CheckError) << way.name;
        }
      }
    }
  }
}

TEST(stage02_fill_ladder, every_rung_but_the_half_fills_the_inside) {
  for (const FillRung& rung : fill_ladder) {
    if (std::string(rung.name) == "half_sweep") continue;
    const PictureText text = filled(rung.fill, {{{1, 1}, {21, 1}, {1, 21}}}, 24, 24);
    for (int y = 2; y < 18; ++y) {
      EXPECT_EQ(text[static_cast<std::size_t>(y)].substr(2, static_cast<std::size_t>(17 - y)),
                std::string(static_cast<std::size_t>(17 - y), '#'))
          << rung.name << " leaves a hole in row " << y;
    }
  }
}

TEST(stage02_fill_ladder, flat_sides_and_repeated_corners_do_not_crash) {
  for (const FillRung& rung : fill_ladder) {
    for (const Corners& corners :
         {Corners{{{2, 3}, {20, 3}, {9, 17}}}, Corners{{{9, 3}, {2, 17}, {20, 17}}},
          Corners{{{5, 5}, {5, 5}, {5, 5}}}, Corners{{{2, 9}, {20, 9}, {11, 9}}},
          Corners{{{9, 2}, {9, 20}, {9, 11}}}, Corners{{{2, 2}, {9, 9}, {2, 2}}}}) {
      EXPECT_NO_THROW(filled(rung.fill, corners, 24, 24)) << rung.name;
    }
  }
}

TEST(stage02_fill_ladder, flat_sides_are_filled) {
  for (const FillRung& rung : fill_ladder) {
    if (std::string(rung.name) == "half_sweep") continue;
    for (const Corners& corners :
         {Corners{{{2, 3}, {20, 3}, {9, 17}}}, Corners{{{9, 3}, {2, 17}, {20, 17}}}}) {
      const PictureText text = filled(rung.fill, corners, 24, 24);
      EXPECT_EQ(text[10][10], '#')
          << rung.name << ": a triangle with a flat top or bottom has an inside";
    }
  }
}

TEST(stage02_fill_ladder, outside_the_image_in_every_direction) {
  for (const FillRung& rung : fill_ladder) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (dx == 0 && dy == 0) continue;
        Corners corners = {{{2, 2}, {9, 3}, {4, 9}}};
        for (Eigen::Vector2d& corner : corners) corner += Eigen::Vector2d(100 * dx, 100 * dy);
        EXPECT_TRUE(
            same_picture(filled(rung.fill, corners, 12, 12), PictureText(12, std::string(12, '.'))))
            << rung.name;
      }
    }
  }
}

TEST(stage02_fill_ladder, partly_outside_draws_the_part_inside) {
  for (const FillRung& rung : fill_ladder) {
    const Corners corners = {{{-30, -20}, {50, 7}, {11, 60}}};
    Image<Rgb8> large(200, 200);
    Corners moved = corners;
    for (Eigen::Vector2d& corner : moved) corner += Eigen::Vector2d(64, 64);
    rung.fill(large, moved, white);
    PictureText expected(20, std::string(20, '.'));
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        if (large(x + 64, y + 64) == white)
          expected[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
      }
    }
    // Rungs that cut x towards 0 or round in float move by a pixel when they cross 0: their known
    // fault.
    const std::string name = rung.name;
    if (name == "edge_functions" || name == "bounding_box" || name == "scanline") {
      EXPECT_TRUE(same_picture(filled(rung.fill, corners, 20, 20), expected)) << name;
    }
  }
}

}  // namespace
}  // namespace rasterlab

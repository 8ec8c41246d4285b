#include "common/zbuffer/draw_depth_line.h"
#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/draw_point.h"

#include "tests/oracle/exact_triangle.h"
#include "tests/support/picture_text.h"

#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

const Color white(1, 1, 1);
const Color red(1, 0, 0);
const Color blue(0, 0, 1);

/// An image and its depth buffer.
struct Canvas {
  Canvas(int width, int height) : image(width, height), depth(width, height) {}
  Image<Rgb8> image;
  DepthBuffer depth;
};

TEST(stage03_draw_point, draws_and_remembers) {
  Canvas canvas(3, 3);
  draw_point(canvas.image, canvas.depth, {1, 2}, 0.5F, white);
  EXPECT_TRUE(covers_exactly(canvas.image, {"...", "...", ".#."}));
  EXPECT_EQ(canvas.depth.depths()(1, 2), 0.5F) << "the depth of what was drawn is stored";
}

TEST(stage03_draw_point, nothing_outside_minus_one_to_one) {
  for (const float z : {-1.0001F, 1.0001F, -5.0F, 5.0F, std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::quiet_NaN()}) {
    Canvas canvas(3, 3);
    draw_point(canvas.image, canvas.depth, {1, 1}, z, white);
    EXPECT_TRUE(covers_exactly(canvas.image, {"...", "...", "..."}))
        << "z = " << z << " is outside [-1, 1]";
    EXPECT_EQ(canvas.depth.depths()(1, 1), 1.0F) << "what is not drawn leaves no depth; z = " << z;
  }
}

TEST(stage03_draw_point, the_near_plane_itself_is_drawn) {
  Canvas canvas(3, 3);
  draw_point(canvas.image, canvas.depth, {1, 1}, -1, white);
  EXPECT_TRUE(covers_exactly(canvas.image, {"...", ".#.", "..."}));
}

TEST(stage03_draw_point, nothing_outside_the_image) {
  Canvas canvas(3, 3);
  for (const Point& point :
       {Point(-1, 1), Point(3, 1), Point(1, -1), Point(1, 3), Point(1 << 30, -(1 << 30))}) {
    EXPECT_NO_THROW(draw_point(canvas.image, canvas.depth, point, 0, white));
  }
  EXPECT_TRUE(covers_exactly(canvas.image, {"...", "...", "..."}));
}

TEST(stage03_draw_point, the_nearest_stays_in_any_order) {
  std::vector<float> depths = {-0.5F, 0, 0.5F};
  do {
    Canvas canvas(1, 1);
    for (const float z : depths)
      draw_point(canvas.image, canvas.depth, {0, 0}, z, z < -0.25F ? red : blue);
    EXPECT_EQ(canvas.image(0, 0), to_rgb8(red))
        << "drawn at z = " << testing::PrintToString(depths);
  } while (std::next_permutation(depths.begin(), depths.end()));
}

TEST(stage03_draw_point, of_equals_the_earlier_stays) {
  Canvas canvas(1, 1);
  draw_point(canvas.image, canvas.depth, {0, 0}, 0.5F, red);
  draw_point(canvas.image, canvas.depth, {0, 0}, 0.5F, blue);
  EXPECT_EQ(canvas.image(0, 0), to_rgb8(red));
}

TEST(stage03_draw_depth_line, ends_have_their_depth_and_colour) {
  Canvas canvas(9, 5);
  draw_depth_line(canvas.image, canvas.depth, {{0, 0}, -0.5F, red}, {{8, 4}, 0.5F, blue});
  EXPECT_EQ(canvas.image(0, 0), to_rgb8(red));
  EXPECT_EQ(canvas.image(8, 4), to_rgb8(blue));
  EXPECT_EQ(canvas.depth.depths()(0, 0), -0.5F);
  EXPECT_EQ(canvas.depth.depths()(8, 4), 0.5F);
  EXPECT_EQ(canvas.depth.depths()(4, 2), 0.0F) << "halfway the depth is halfway";
}

TEST(stage03_draw_depth_line, one_pixel) {
  Canvas canvas(3, 3);
  draw_depth_line(canvas.image, canvas.depth, {{1, 1}, 0.25F, red}, {{1, 1}, -0.25F, blue});
  EXPECT_TRUE(covers_exactly(canvas.image, {"...", ".#.", "..."}));
  EXPECT_EQ(canvas.image(1, 1), to_rgb8(red))
      << "a segment of one pixel has its start's depth and colour";
  EXPECT_EQ(canvas.depth.depths()(1, 1), 0.25F);
}

TEST(stage03_draw_depth_line, the_nearer_hides_in_any_order) {
  for (const bool near_first : {true, false}) {
    Canvas canvas(5, 5);
    const auto near_one = [&] {
      draw_depth_line(canvas.image, canvas.depth, {{0, 2}, -0.5F, red}, {{4, 2}, -0.5F, red});
    };
    const auto far_one = [&] {
      draw_depth_line(canvas.image, canvas.depth, {{2, 0}, 0.5F, blue}, {{2, 4}, 0.5F, blue});
    };
    near_first ? near_one() : far_one();
    near_first ? far_one() : near_one();
    EXPECT_EQ(canvas.image(2, 2), to_rgb8(red))
        << "where they cross, the nearer is seen; drawn first: " << near_first;
  }
}

TEST(stage03_draw_depth_line, cut_off_in_depth_pixel_by_pixel) {
  Canvas canvas(9, 1);
  draw_depth_line(canvas.image, canvas.depth, {{0, 0}, -2, red}, {{8, 0}, 2, red});
  EXPECT_TRUE(covers_exactly(canvas.image, {"..####..."}))
      << "from z = -2 to 2, only -1 ... 1 is drawn (z = 1 is no nearer than a cleared buffer)";
}

TEST(stage03_draw_depth_line, outside_in_every_direction) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      Canvas canvas(7, 7);
      const Point far_point(3 + dx * (1 << 20), 3 + dy * (1 << 20));
      draw_depth_line(canvas.image, canvas.depth, {{3, 3}, 0, red}, {far_point, 0, red});
      Canvas expected(7, 7);
      for (int k = 0; k < 4; ++k)
        draw_point(expected.image, expected.depth, {3 + k * dx, 3 + k * dy}, 0, red);
      EXPECT_TRUE(same_picture(picture_text(canvas.image), picture_text(expected.image)))
          << "toward (" << dx << ", " << dy << ")";
    }
  }
}

TEST(stage03_draw_depth_line, out_to_the_largest_coordinates) {
  constexpr int far_away = 1 << 30;
  Canvas canvas(5, 3);
  draw_depth_line(canvas.image, canvas.depth, {{-far_away, 1}, -0.5F, red},
                  {{far_away, 1}, 0.5F, red});
  EXPECT_TRUE(covers_exactly(canvas.image, {".....", "#####", "....."}));
  EXPECT_NEAR(canvas.depth.depths()(2, 1), 0, 1e-6) << "halfway the depth is halfway";
  for (const Point& beyond : {Point(far_away + 1, 1), Point(1, -far_away - 1)}) {
    EXPECT_THROW(draw_depth_line(canvas.image, canvas.depth, {{0, 0}, 0, red}, {beyond, 0, red}),
                 CheckError);
  }
}

std::array<DepthCorner, 3> triangle(const std::array<Eigen::Vector2f, 3>& p,
                                    const std::array<float, 3>& z, const std::array<Color, 3>& c) {
  return {DepthCorner{p[0].cast<double>(), z[0], c[0]},
          DepthCorner{p[1].cast<double>(), z[1], c[1]},
          DepthCorner{p[2].cast<double>(), z[2], c[2]}};
}

TEST(stage03_draw_depth_triangle, depth_and_colour_against_exact_weights) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-20, 60);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    std::array<Eigen::Vector2f, 3> p;
    std::array<float, 3> z{};
    std::array<Color, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = {place(random), place(random)};
      z[k] = unit(random) - 0.5F;
      c[k] = {unit(random), unit(random), unit(random)};
    }
    Canvas canvas(40, 40);
    draw_depth_triangle(canvas.image, canvas.depth, triangle(p, z, c));
    const oracle::GridTriangle grid =
        oracle::to_grid({p[0].cast<double>(), p[1].cast<double>(), p[2].cast<double>()});
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        if (!oracle::covers(grid, x, y)) {
          ASSERT_EQ(canvas.depth.depths()(x, y), 1.0F)
              << "not covered, yet drawn: (" << x << ", " << y << ")";
          continue;
        }
        const auto w = oracle::weights(grid, x, y);
        long double expected_z = 0;
        Eigen::Vector3d expected_color(0, 0, 0);
        for (std::size_t k = 0; k < 3; ++k) {
          expected_z += w[k] * z[k];
          expected_color += static_cast<double>(w[k]) * c[k].cast<double>();
        }
        ASSERT_NEAR(canvas.depth.depths()(x, y), static_cast<double>(expected_z), 1e-6)
            << "depth at (" << x << ", " << y << ")";
        const Rgb8 pixel = canvas.image(x, y);
        ASSERT_NEAR(pixel.r, expected_color.x() * 255, 1) << "red at (" << x << ", " << y << ")";
        ASSERT_NEAR(pixel.g, expected_color.y() * 255, 1) << "green at (" << x << ", " << y << ")";
        ASSERT_NEAR(pixel.b, expected_color.z() * 255, 1) << "blue at (" << x << ", " << y << ")";
      }
    }
  }
}

TEST(stage03_draw_depth_triangle, passing_through_each_other_they_meet_in_a_line) {
  for (const bool red_first : {true, false}) {
    Canvas canvas(8, 8);
    const auto left_near =
        triangle({{{0, 0}, {8, 0}, {0, 8}}}, {-0.5F, 0.5F, -0.5F}, {red, red, red});
    const auto right_near =
        triangle({{{0, 0}, {8, 0}, {0, 8}}}, {0.5F, -0.5F, 0.5F}, {blue, blue, blue});
    draw_depth_triangle(canvas.image, canvas.depth, red_first ? left_near : right_near);
    draw_depth_triangle(canvas.image, canvas.depth, red_first ? right_near : left_near);
    EXPECT_TRUE(same_picture(picture_text_by(canvas.image,
                                             [](const Rgb8& pixel) {
                                               return pixel.r > 0 ? 'r' : pixel.b > 0 ? 'b' : '.';
                                             }),
                             {"rrrrbbb.", "rrrrbb..", "rrrrb...", "rrrr....", "rrr.....",
                              "rr......", "r.......", "........"}))
        << "each is seen where it is nearer";
  }
}

TEST(stage03_draw_depth_triangle, degenerate_draws_nothing) {
  for (const auto& corners : {std::array<Eigen::Vector2f, 3>{{{1, 1}, {1, 1}, {1, 1}}},
                              std::array<Eigen::Vector2f, 3>{{{0, 0}, {4, 4}, {8, 8}}},
                              std::array<Eigen::Vector2f, 3>{{{0, 2}, {8, 2}, {0, 2}}}}) {
    Canvas canvas(8, 8);
    draw_depth_triangle(canvas.image, canvas.depth, triangle(corners, {0, 0, 0}, {red, red, red}));
    EXPECT_EQ(canvas.image, Image<Rgb8>(8, 8)) << "a triangle without area covers no pixel";
  }
}

TEST(stage03_draw_depth_triangle, either_winding_draws_the_same) {
  const auto corners =
      triangle({{{1, 1}, {30, 5}, {12, 29}}}, {-0.3F, 0.1F, 0.7F}, {red, white, blue});
  Canvas one(32, 32);
  draw_depth_triangle(one.image, one.depth, corners);
  Canvas other(32, 32);
  draw_depth_triangle(other.image, other.depth, {corners[0], corners[2], corners[1]});
  EXPECT_TRUE(same_picture(picture_text(other.image), picture_text(one.image)));
}

TEST(stage03_draw_depth_triangle, out_to_the_largest_coordinates) {
  const float far_away = 0x1p30F;
  Canvas canvas(4, 2);
  draw_depth_triangle(canvas.image, canvas.depth,
                      triangle({{{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}}},
                               {0.25F, 0.25F, 0.25F}, {red, red, red}));
  EXPECT_TRUE(covers_exactly(canvas.image, {"####", "####"})) << "the image is inside";
  EXPECT_NEAR(canvas.depth.depths()(1, 1), 0.25, 1e-6);
  for (const float beyond :
       {1.0001F * far_away, -1.0001F * far_away, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(
        draw_depth_triangle(canvas.image, canvas.depth,
                            triangle({{{0, 0}, {4, 0}, {0, beyond}}}, {0, 0, 0}, {red, red, red})),
        CheckError)
        << beyond;
  }
}

TEST(stage03_draw_depth_triangle, cut_off_in_depth_pixel_by_pixel) {
  Canvas canvas(8, 2);
  draw_depth_triangle(canvas.image, canvas.depth,
                      triangle({{{0, 0}, {8, 0}, {0, 8}}}, {-2, 2, -2}, {red, red, red}));
  EXPECT_TRUE(covers_exactly(canvas.image, {"..####..", "..####.."}))
      << "z goes from -2 at the left to 2 at the right";
}

}  // namespace
}  // namespace rasterlab

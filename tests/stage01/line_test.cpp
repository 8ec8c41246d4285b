// Lines as sequences of pixels: exercises 01.4, 01.6, 01.8 and 01.9.
#include "common/lines/bresenham_first_octant.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_discrete.h"
#include "common/lines/line_faults.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/octants.h"

#include "tests/oracle/exact_segment.h"

#include <random>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

std::vector<Point> pixels_of(const LineDiscrete& line) {
  return {line.begin(), line.end()};
}

template <class Printed>
std::string printed(const Printed& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

constexpr int far = max_point_coordinate;

// 01.4

TEST(stage01_line_discrete, keeps_what_is_appended_in_order) {
  LineDiscrete line;
  EXPECT_TRUE(line.empty());
  line.append({3, 4});
  line.append({-1, 2});
  line.append({3, 4});
  ASSERT_EQ(line.size(), 3U) << "repetitions are kept too";
  EXPECT_EQ(line[0], Point(3, 4));
  EXPECT_EQ(line[1], Point(-1, 2));
  EXPECT_EQ(line[2], Point(3, 4));
}

TEST(stage01_line_discrete, goes_both_ways) {
  const LineDiscrete line = {{0, 0}, {1, 0}, {2, 1}};
  const std::vector<Point> there = pixels_of(line);
  const std::vector<Point> back(line.rbegin(), line.rend());
  EXPECT_EQ(there, (std::vector<Point>{{0, 0}, {1, 0}, {2, 1}}));
  EXPECT_EQ(back, (std::vector<Point>{{2, 1}, {1, 0}, {0, 0}}));
}

TEST(stage01_line_discrete, is_printed_as_its_contract_says) {
  EXPECT_EQ(printed(LineDiscrete{{5, 5}, {6, -6}}), "(5,5)(6,-6)");
  EXPECT_EQ(printed(LineDiscrete{}), "");
}

TEST(stage01_line_discrete, a_pixel_that_is_not_there_throws) {
  const LineDiscrete line = {{0, 0}};
  EXPECT_THROW(line[1], CheckError);
  EXPECT_THROW(LineDiscrete()[0], CheckError);
}

// 01.6

TEST(stage01_bresenham_first_octant, the_courses_example) {
  EXPECT_EQ(printed(bresenham_first_octant({5, 5}, {12, 9})),
            "(5,5)(6,6)(7,6)(8,7)(9,7)(10,8)(11,8)(12,9)");
}

TEST(stage01_bresenham_first_octant, every_slope) {
  for (int dx = 0; dx <= 60; ++dx) {
    for (int dy = 0; dy <= dx; ++dy) {
      const Point p0(-7, 11);
      const Point p1 = p0 + Point(dx, dy);
      ASSERT_EQ(oracle::line_mistake(pixels_of(bresenham_first_octant(p0, p1)), p0, p1), "");
    }
  }
}

TEST(stage01_bresenham_first_octant, one_pixel) {
  EXPECT_EQ(printed(bresenham_first_octant({3, -3}, {3, -3})), "(3,-3)");
}

TEST(stage01_bresenham_first_octant, other_octants_are_refused) {
  for (const Point& p1 : {Point(1, 2), Point(-2, 1), Point(2, -1), Point(-1, -2)}) {
    EXPECT_THROW(bresenham_first_octant({0, 0}, p1), CheckError) << p1.transpose();
  }
}

TEST(stage01_bresenham_first_octant, a_part_is_the_part_of_the_whole) {
  const Point p0(2, 3);
  for (const Point& p1 : {Point(40, 3), Point(40, 41), Point(40, 22), Point(39, 14), Point(2, 3)}) {
    const std::vector<Point> whole = pixels_of(bresenham_first_octant(p0, p1));
    for (std::int64_t first = -2; first <= 40; ++first) {
      for (std::int64_t last = first - 1; last <= 42; last += 3) {
        std::vector<Point> expected;
        for (std::int64_t k = std::max<std::int64_t>(first, 0); k <= last && k < std::ssize(whole);
             ++k) {
          expected.push_back(whole[static_cast<std::size_t>(k)]);
        }
        ASSERT_EQ(pixels_of(bresenham_first_octant(p0, p1, {first, last})), expected)
            << "steps " << first << " to " << last << " must be pixels the whole line has there";
      }
    }
  }
}

TEST(stage01_bresenham_first_octant, at_the_edge_of_the_coordinates) {
  const Point p0(-far, -far);
  for (const Point& p1 :
       {Point(far, far), Point(far, far - 1), Point(far, 12345), Point(far, -far)}) {
    const oracle::ExactSegment segment(p0, p1);
    for (const std::int64_t first :
         {std::int64_t{0}, std::int64_t{1} << 30, (std::int64_t{1} << 31) - 5}) {
      const LineDiscrete part = bresenham_first_octant(p0, p1, {first, first + 5});
      ASSERT_EQ(part.size(), 6U);
      for (const Point& pixel : part)
        EXPECT_TRUE(segment.is_near(pixel)) << pixel.transpose() << ": an overflow?";
    }
  }
}

// 01.8

/// The eight octants that a vector is in: one, or two on a border.
std::vector<int> octants_of(int dx, int dy) {
  std::vector<int> octants;
  const auto add_if = [&](int octant, bool in) {
    if (in) octants.push_back(octant);
  };
  add_if(1, 0 <= dy && dy <= dx);
  add_if(2, 0 <= dx && dx <= dy);
  add_if(3, 0 <= -dx && -dx <= dy);
  add_if(4, 0 <= dy && dy <= -dx);
  add_if(5, 0 <= -dy && -dy <= -dx);
  add_if(6, 0 <= -dx && -dx <= -dy);
  add_if(7, 0 <= dx && dx <= -dy);
  add_if(8, 0 <= -dy && -dy <= dx);
  return octants;
}

TEST(stage01_octant_number, every_direction) {
  for (int dy = -12; dy <= 12; ++dy) {
    for (int dx = -12; dx <= 12; ++dx) {
      EXPECT_THAT(octants_of(dx, dy), testing::Contains(octant_number({3, 4}, {3 + dx, 4 + dy})))
          << "direction (" << dx << "," << dy << ")";
    }
  }
}

TEST(stage01_octant_number, at_the_edge_of_the_coordinates) {
  EXPECT_EQ(octant_number({-far, -far}, {far, far - 1}), 1);
  EXPECT_EQ(octant_number({far, -far}, {-far, far - 1}), 4);
  EXPECT_EQ(octant_number({far, far}, {1 - far, -far}), 6);
}

TEST(stage01_symmetry_octant, turns_every_octant_into_the_first) {
  for (int dy = -12; dy <= 12; ++dy) {
    for (int dx = -12; dx <= 12; ++dx) {
      for (const int octant : octants_of(dx, dy)) {
        const Point turned = symmetry_octant({dx, dy}, octant);
        EXPECT_TRUE(0 <= turned.y() && turned.y() <= turned.x())
            << "(" << dx << "," << dy << ") of octant " << octant << " became ("
            << turned.transpose() << ")";
        EXPECT_EQ(turned.cwiseAbs().sum(), std::abs(dx) + std::abs(dy))
            << "a symmetry keeps lengths";
      }
    }
  }
}

TEST(stage01_symmetry_octant, the_inverse_undoes_it) {
  for (int octant = 1; octant <= 8; ++octant) {
    for (const Point& p : {Point(3, 1), Point(-5, 2), Point(0, -7), Point(far, -far)}) {
      EXPECT_EQ(symmetry_octant_inverse(symmetry_octant(p, octant), octant), p)
          << "octant " << octant;
      EXPECT_EQ(symmetry_octant(symmetry_octant_inverse(p, octant), octant), p)
          << "octant " << octant;
    }
  }
}

TEST(stage01_symmetry_octant, there_are_eight) {
  for (const int octant : {0, 9, -1}) {
    EXPECT_THROW(symmetry_octant({1, 0}, octant), CheckError);
    EXPECT_THROW(symmetry_octant_inverse({1, 0}, octant), CheckError);
  }
}

TEST(stage01_line_all_octants, every_direction) {
  for (const Segment& segment : short_segments()) {
    for (const Point& p0 : {Point(0, 0), Point(-100, 35)}) {
      const Point p1 = p0 + segment.p1;
      ASSERT_EQ(oracle::line_mistake(pixels_of(line_all_octants(p0, p1)), p0, p1), "");
    }
  }
}

TEST(stage01_line_all_octants, long_ones) {
  for (const Segment& segment : random_segments(200, 3000)) {
    ASSERT_EQ(oracle::line_mistake(pixels_of(line_all_octants(segment.p0, segment.p1)), segment.p0,
                                   segment.p1),
              "");
  }
}

TEST(stage01_line_all_octants, parts_far_away) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<int>(random() % (2U * far + 1U)) - far; };
  for (int i = 0; i < 300; ++i) {
    const Point p0(coordinate(), coordinate());
    const Point p1(coordinate(), coordinate());
    const oracle::ExactSegment segment(p0, p1);
    const std::int64_t first = segment.steps() / 3;
    const LineDiscrete part = line_all_octants(p0, p1, {first, first + 9});
    ASSERT_EQ(part.size(), 10U);
    for (const Point& pixel : part) ASSERT_TRUE(segment.is_near(pixel)) << pixel.transpose();
  }
}

// 01.9

TEST(stage01_line_interpolation, from_zero_to_one) {
  const LineInterpolation weights(LineDiscrete{{0, 0}, {1, 1}, {2, 1}, {3, 2}, {4, 2}});
  ASSERT_EQ(weights.size(), 5U);
  EXPECT_EQ(weights[0], 0);
  EXPECT_NEAR(weights[1], std::sqrt(2.0 / 20.0), 1e-12);
  EXPECT_NEAR(weights[2], std::sqrt(5.0 / 20.0), 1e-12);
  EXPECT_NEAR(weights[3], std::sqrt(13.0 / 20.0), 1e-12);
  EXPECT_NEAR(weights[4], 1, 1e-12);
}

TEST(stage01_line_interpolation, one_pixel_and_none) {
  const LineInterpolation one(LineDiscrete{{7, 7}});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0], 0) << "0/0 is no number: a line of one pixel has the weight 0";
  EXPECT_EQ(LineInterpolation(LineDiscrete{}).size(), 0U);
}

TEST(stage01_line_interpolation, some_pixels_of_a_longer_line) {
  const LineInterpolation weights(LineDiscrete{{5, 0}, {6, 0}}, {0, 0}, {20, 0});
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.30, 1e-12);
}

TEST(stage01_line_interpolation, at_the_edge_of_the_coordinates) {
  const LineInterpolation weights(LineDiscrete{{-far, -far}, {0, 0}, {far, far}});
  EXPECT_NEAR(weights[1], 0.5, 1e-12);
  EXPECT_NEAR(weights[2], 1, 1e-12);
}

TEST(stage01_line_interpolation, is_printed_as_its_contract_says) {
  EXPECT_EQ(printed(LineInterpolation(LineDiscrete{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}})),
            "0 0.25 0.5 0.75 1");
}

TEST(stage01_line_interpolation, a_weight_that_is_not_there_throws) {
  EXPECT_THROW(LineInterpolation(LineDiscrete{{0, 0}})[1], CheckError);
}

}  // namespace
}  // namespace rasterlab

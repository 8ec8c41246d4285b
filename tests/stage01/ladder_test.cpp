// The ladder of segments, exercise 01.5: the last rung is right, the others have the faults they
// are known for.
#include "common/lines/bresenham.h"
#include "common/lines/line_faults.h"
#include "common/lines/line_ladder.h"

#include "tests/oracle/exact_segment.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

std::vector<Point> pixels_of(const LineDiscrete& line) {
  return {line.begin(), line.end()};
}

std::set<std::pair<int, int>> set_of(const LineDiscrete& line) {
  std::set<std::pair<int, int>> pixels;
  for (const Point& pixel : line) pixels.insert({pixel.x(), pixel.y()});
  return pixels;
}

TEST(stage01_line_bresenham, every_direction) {
  for (const Segment& segment : short_segments()) {
    for (const Point& p0 : {Point(0, 0), Point(-31, 17)}) {
      const Point p1 = p0 + segment.p1;
      ASSERT_EQ(oracle::line_mistake(pixels_of(line_bresenham(p0, p1)), p0, p1, true), "");
    }
  }
}

TEST(stage01_line_bresenham, long_ones) {
  for (const Segment& segment : random_segments(300, 4000)) {
    ASSERT_EQ(oracle::line_mistake(pixels_of(line_bresenham(segment.p0, segment.p1)), segment.p0,
                                   segment.p1, true),
              "");
  }
}

TEST(stage01_line_bresenham, the_diagonal_starts_where_it_should) {
  const std::vector<Point> pixels = pixels_of(line_bresenham({0, 0}, {10, 10}));
  EXPECT_THAT(pixels, testing::Contains(Point(0, 0))) << "stepped before it plotted?";
  EXPECT_THAT(pixels, testing::Contains(Point(10, 10)));
  EXPECT_EQ(pixels.size(), 11U);
}

TEST(stage01_line_bresenham, where_coordinates_are_largest) {
  constexpr int far = max_point_coordinate;
  for (const auto& [p0, p1] : {std::pair{Point(far - 9, -far), Point(far, 3 - far)},
                               {Point(-far, far - 20), Point(7 - far, far)},
                               {Point(far, far), Point(far, far)}}) {
    EXPECT_EQ(oracle::line_mistake(pixels_of(line_bresenham(p0, p1)), p0, p1, true), "");
  }
}

// The checks themselves: what is right in another way passes, what is wrong does not.

TEST(stage01_line_bresenham, the_check_takes_ties_either_way) {
  EXPECT_EQ(oracle::line_mistake({{0, 0}, {1, 0}, {2, 1}}, {0, 0}, {2, 1}), "");
  EXPECT_EQ(oracle::line_mistake({{0, 0}, {1, 1}, {2, 1}}, {0, 0}, {2, 1}), "");
}

TEST(stage01_line_bresenham, the_check_knows_where_ties_are) {
  for (const Segment& segment : short_segments()) {
    const oracle::ExactSegment exact(segment.p0, segment.p1);
    const Point box = (segment.p1 - segment.p0).cwiseAbs();
    bool found = false;
    for (int y = -box.y() - 1; y <= box.y() + 1; ++y) {
      for (int x = -box.x() - 1; x <= box.x() + 1; ++x) {
        const Point pixel = segment.p0 + Point(x, y);
        found = found || (exact.is_near(pixel) && exact.distance(pixel) == 0.5L);
      }
    }
    ASSERT_EQ(exact.has_ties(), found) << segment.p0.transpose() << " " << segment.p1.transpose();
  }
}

TEST(stage01_line_bresenham, the_check_finds_each_mistake) {
  const auto mistake = [](const std::vector<Point>& pixels) {
    return oracle::line_mistake(pixels, {0, 0}, {4, 2});
  };
  using testing::HasSubstr;
  EXPECT_THAT(mistake({}), HasSubstr("no pixels"));
  EXPECT_THAT(mistake({{1, 0}, {2, 1}, {3, 1}, {4, 2}}), HasSubstr("begins at (1,0)"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {2, 1}, {3, 1}}), HasSubstr("ends at (3,1)"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {3, 1}, {4, 2}}), HasSubstr("gap between (1,0) and (3,1)"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}}),
              HasSubstr("(1,0) comes twice"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}}),
              HasSubstr("(2,0) is more than half a pixel"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 2}}),
              HasSubstr("not one for each of 5 columns"));
}

// The measured faults against arithmetic of their own.

TEST(stage01_line_ladder, faults_are_what_exact_arithmetic_counts) {
  std::vector<Segment> segments = short_segments();
  const std::vector<Segment> more = random_segments(50, 700);
  segments.insert(segments.end(), more.begin(), more.end());
  for (const LineRung& rung : line_ladder) {
    LineFaults counted;
    long double distance = 0;
    for (const Segment& segment : segments) {
      const std::vector<Point> pixels = pixels_of(rung.line(segment.p0, segment.p1));
      const oracle::ExactSegment exact(segment.p0, segment.p1);
      for (const Point& pixel : pixels) distance = std::max(distance, exact.distance(pixel));
      for (std::size_t i = 1; i < pixels.size(); ++i) {
        const Point step = (pixels[i] - pixels[i - 1]).cwiseAbs();
        counted.gaps += step.x() > 1 || step.y() > 1 ? 1 : 0;
      }
      const auto there = set_of(rung.line(segment.p0, segment.p1));
      const auto back = set_of(rung.line(segment.p1, segment.p0));
      counted.missing_ends += there.count({segment.p0.x(), segment.p0.y()}) == 0 ? 1 : 0;
      counted.missing_ends += there.count({segment.p1.x(), segment.p1.y()}) == 0 ? 1 : 0;
      counted.doubled += std::ssize(pixels) - std::ssize(there);
      counted.changed_by_swap +=
          std::count_if(there.begin(), there.end(), [&](auto p) { return back.count(p) == 0; });
      counted.changed_by_swap +=
          std::count_if(back.begin(), back.end(), [&](auto p) { return there.count(p) == 0; });
    }
    const LineFaults measured = line_faults(rung.line, segments);
    EXPECT_EQ(measured.gaps, counted.gaps) << rung.name;
    EXPECT_EQ(measured.missing_ends, counted.missing_ends) << rung.name;
    EXPECT_EQ(measured.doubled, counted.doubled) << rung.name;
    EXPECT_EQ(measured.changed_by_swap, counted.changed_by_swap) << rung.name;
    EXPECT_NEAR(measured.distance, static_cast<double>(distance), 1e-12) << rung.name;
  }
}

const LineRung& rung_named(const std::string& name) {
  return *std::find_if(line_ladder.begin(), line_ladder.end(),
                       [&](const LineRung& rung) { return rung.name == name; });
}

TEST(stage01_line_ladder, every_rung_but_the_last_has_its_known_fault) {
  const auto faults = [](const std::string& name, int reach) {
    return line_faults(rung_named(name).line, random_segments(20, reach));
  };
  EXPECT_GT(faults("ten_steps", 500).gaps, 0);
  EXPECT_GT(faults("ten_steps", 2).doubled, 0);
  EXPECT_GT(faults("hundred_steps", 500).gaps, 0);
  EXPECT_GT(faults("hundred_steps", 20).doubled, 0);
  EXPECT_GT(faults("hundred_steps", 500).missing_ends, 0);
  EXPECT_GT(faults("column_steps", 500).gaps, 0);
  EXPECT_GT(faults("column_steps", 500).missing_ends, 0);
  EXPECT_GT(faults("swapped_columns", 500).distance, 0.9);
  EXPECT_GT(faults("hoisted_slope", 500).missing_ends, 0);
  EXPECT_GT(faults("split_fraction", 50000).distance, 0.5);
}

TEST(stage01_line_ladder, the_last_rung_has_none) {
  for (const int reach : {3, 20, 500, 50000}) {
    const LineFaults faults = line_faults(line_ladder.back().line, random_segments(40, reach));
    EXPECT_LE(faults.distance, 0.5);
    EXPECT_EQ(faults.gaps, 0);
    EXPECT_EQ(faults.missing_ends, 0);
    EXPECT_EQ(faults.doubled, 0);
  }
}

// What each rung's contract says of the courses' own segment (13,20)-(80,40) and of others.

TEST(stage01_line_ladder, fixed_steps) {
  EXPECT_EQ(
      rung_named("ten_steps").line({0, 0}, {30, 10}),
      (LineDiscrete{
          {0, 0}, {3, 1}, {6, 2}, {9, 3}, {12, 4}, {15, 5}, {18, 6}, {21, 7}, {24, 8}, {27, 9}}));
  const LineDiscrete hundred = rung_named("hundred_steps").line({13, 20}, {80, 40});
  EXPECT_EQ(hundred.size(), 100U);
  EXPECT_EQ(hundred[0], Point(13, 20));
  EXPECT_EQ(hundred[50], Point(46, 30));
}

TEST(stage01_line_ladder, column_steps) {
  EXPECT_EQ(rung_named("column_steps").line({0, 0}, {4, 8}),
            (LineDiscrete{{0, 0}, {1, 2}, {2, 4}, {3, 6}, {4, 8}}));
  EXPECT_TRUE(rung_named("column_steps").line({4, 8}, {0, 0}).empty())
      << "nothing from right to left";
  EXPECT_EQ(rung_named("column_steps").line({2, 3}, {2, 9}), (LineDiscrete{{2, 3}}))
      << "no division by 0";
}

TEST(stage01_line_ladder, every_rung_from_swapped_columns_on_goes_every_way) {
  for (const char* name : {"swapped_columns", "hoisted_slope", "split_fraction", "bresenham"}) {
    for (const Segment& segment : short_segments()) {
      const LineDiscrete line = rung_named(name).line(segment.p0, segment.p1);
      const auto length = static_cast<std::size_t>(segment.p1.cwiseAbs().maxCoeff()) + 1;
      ASSERT_EQ(line.size(), length) << name << " to (" << segment.p1.transpose() << ")";
    }
  }
}

}  // namespace
}  // namespace rasterlab

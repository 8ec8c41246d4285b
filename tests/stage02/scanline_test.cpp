// Exercises 02.2 and 02.5.
#include "common/triangles/interpolate_attributes.h"
#include "common/triangles/triangle_scanline.h"

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

const std::array<Point, 3> course_triangle = {{{15, 12}, {2, 17}, {6, 3}}};

TEST(stage02_triangle_scanline, course_example) {
  const auto scanline = make_triangle_scanline<float>(course_triangle, {0, 1, 2});
  ASSERT_EQ(scanline.size(), 15U) << "rows 3 to 17";
  const auto& top = *scanline.begin();
  EXPECT_EQ(top.y, 3);
  EXPECT_EQ(top.left, 6);
  EXPECT_EQ(top.right, 6);
  EXPECT_EQ(top.left_value, 2.0F);
  const auto& widest = *(scanline.begin() + 9);
  EXPECT_EQ(widest.y, 12);
  EXPECT_EQ(widest.left, 3);
  EXPECT_EQ(widest.right, 15);
  EXPECT_EQ(widest.right_value, 0.0F) << "corner (15, 12) has the value 0";
  const auto& bottom = *scanline.rbegin();
  EXPECT_EQ(bottom.y, 17);
  EXPECT_EQ(bottom.left, 2);
  EXPECT_EQ(bottom.left_value, 1.0F);
}

TEST(stage02_triangle_scanline, colours_too) {
  const auto scanline = make_triangle_scanline<Eigen::Vector3f>(
      course_triangle,
      {Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0, 0, 1)});
  EXPECT_EQ(scanline.begin()->left_value, Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(scanline.rbegin()->left_value, Eigen::Vector3f(0, 1, 0));
}

TEST(stage02_triangle_scanline, both_ways_are_the_same_rows) {
  const auto scanline = make_triangle_scanline<float>(course_triangle, {0, 1, 2});
  std::vector<int> down;
  for (const auto& row : scanline) down.push_back(row.y);
  std::vector<int> up;
  for (auto row = scanline.rbegin(); row != scanline.rend(); ++row) up.push_back(row->y);
  std::reverse(up.begin(), up.end());
  EXPECT_EQ(down, up);
  EXPECT_TRUE(std::is_sorted(down.begin(), down.end())) << "rows come from the top down";
}

// Left and right must be the outermost pixels of the discrete sides, whichever of two equally near
// ones a side has.
TEST(stage02_triangle_scanline, ends_are_within_half_a_pixel_of_the_sides) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(-30, 30);
  for (int i = 0; i < 500; ++i) {
    std::array<Point, 3> corners;
    for (Point& corner : corners) corner = {place(random), place(random)};
    std::map<int, std::pair<double, double>>
        reach;  // per row, the extent of the ideal sides within half a pixel of it
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d a = corners[k].cast<double>();
      const Eigen::Vector2d b = corners[(k + 1) % 3].cast<double>();
      for (int y = static_cast<int>(std::min(a.y(), b.y()));
           y <= static_cast<int>(std::max(a.y(), b.y())); ++y) {
        for (const double row : {y - 0.5, y + 0.0, y + 0.5}) {
          const double t =
              a.y() == b.y() ? 0 : std::clamp((row - a.y()) / (b.y() - a.y()), 0.0, 1.0);
          for (const double x : {a.x() + t * (b.x() - a.x()),
                                 a.y() == b.y() ? b.x() : a.x() + t * (b.x() - a.x())}) {
            const auto [entry, added] = reach.try_emplace(y, x, x);
            if (!added)
              entry->second = {std::min(entry->second.first, x), std::max(entry->second.second, x)};
          }
        }
      }
    }
    const auto scanline = make_triangle_scanline<float>(corners, {0, 0, 0});
    ASSERT_EQ(scanline.size(), reach.size()) << "one row for each that a side crosses";
    for (const auto& row : scanline) {
      ASSERT_LE(row.left, row.right);
      ASSERT_NEAR(row.left, reach.at(row.y).first, 1 + 1e-9) << "left end of row " << row.y;
      ASSERT_NEAR(row.right, reach.at(row.y).second, 1 + 1e-9) << "right end of row " << row.y;
    }
  }
}

TEST(stage02_triangle_scanline, values_are_linear_along_the_sides) {
  const auto scanline = make_triangle_scanline<float>({{{0, 0}, {40, 80}, {0, 80}}}, {0, 80, 80});
  for (const auto& row : scanline) {
    EXPECT_NEAR(row.left_value, row.y, 1.0) << "the value is y on the left side";
    EXPECT_NEAR(row.right_value, row.y, 1.0) << "and on the right side, row " << row.y;
  }
}

TEST(stage02_triangle_scanline, degenerate) {
  const auto point = make_triangle_scanline<float>({{{4, 4}, {4, 4}, {4, 4}}}, {1, 1, 1});
  ASSERT_EQ(point.size(), 1U);
  EXPECT_EQ(point.begin()->left, 4);
  EXPECT_EQ(point.begin()->left_value, 1.0F) << "one pixel: no 0/0";
  const auto flat = make_triangle_scanline<float>({{{1, 4}, {9, 4}, {5, 4}}}, {0, 8, 4});
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat.begin()->left, 1);
  EXPECT_EQ(flat.begin()->right, 9);
}

TEST(stage02_triangle_scanline, only_some_rows_of_a_huge_one) {
  constexpr int far_away = 1 << 30;
  const auto scanline = make_triangle_scanline<float>(
      {{{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}}}, {0, 0, 1},
      {.first = 0, .last = 9});
  ASSERT_EQ(scanline.size(), 10U);
  EXPECT_EQ(scanline.begin()->left, -far_away / 2);
  EXPECT_EQ(scanline.begin()->right, far_away / 2);
  EXPECT_NEAR(scanline.begin()->left_value, 0.5, 1e-6);
}

TEST(stage02_triangle_scanline, printed) {
  std::ostringstream text;
  text << make_triangle_scanline<float>(course_triangle, {0, 1, 2});
  EXPECT_THAT(text.str(), testing::StartsWith("y=3: 6 [2] to 6 [2]\n"));
  EXPECT_THAT(text.str(), testing::HasSubstr("\ny=12: 3 ["));
}

TEST(stage02_interpolate_attributes, weights_each_corner) {
  Eigen::MatrixX3d corners(2, 3);
  corners << 0, 10, 20, 1, 1, 4;
  const Eigen::VectorXd middle = interpolate_attributes(corners, {0.25, 0.25, 0.5});
  ASSERT_EQ(middle.size(), 2) << "one result for each attribute";
  EXPECT_NEAR(middle[0], 12.5, 1e-12);
  EXPECT_NEAR(middle[1], 2.5, 1e-12);
}

TEST(stage02_interpolate_attributes, at_the_corners) {
  Eigen::MatrixX3d corners(1, 3);
  corners << 3, 5, 7;
  EXPECT_EQ(interpolate_attributes(corners, {1, 0, 0})[0], 3)
      << "all weight on corner 0: exactly its value";
  EXPECT_NEAR(interpolate_attributes(corners, {0, 1, 0})[0], 5, 1e-12);
  EXPECT_NEAR(interpolate_attributes(corners, {0, 0, 1})[0], 7, 1e-12);
}

TEST(stage02_interpolate_attributes, equal_corners_give_exactly_that) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double value = unit(random) * 1e3;
    const Eigen::MatrixX3d corners = Eigen::MatrixX3d::Constant(3, 3, value);
    const double w1 = unit(random);
    const double w2 = (1 - w1) * unit(random);
    const Eigen::VectorXd result = interpolate_attributes(corners, {1 - w1 - w2, w1, w2});
    for (const double r : result)
      ASSERT_EQ(r, value) << "three equal values blend to that value, to the last bit";
  }
}

TEST(stage02_interpolate_attributes, any_number_of_them) {
  for (const int count : {0, 1, 17}) {
    const Eigen::MatrixX3d corners = Eigen::MatrixX3d::Random(count, 3);
    EXPECT_EQ(interpolate_attributes(corners, {0.2, 0.3, 0.5}).size(), count);
  }
}

}  // namespace
}  // namespace rasterlab

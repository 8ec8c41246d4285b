#include "common/triangles/rasterize.h"

#include "tests/oracle/exact_triangle.h"

#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Corners = std::array<Eigen::Vector2f, 3>;

std::array<Eigen::Vector2d, 3> to_double(const Corners& corners) {
  return {corners[0].cast<double>(), corners[1].cast<double>(), corners[2].cast<double>()};
}

// A correctly rounded double is this near, relatively; the oracle's own rounding to a long double
// on top.
constexpr long double half_ulp = 0x1.01p-53L;

// Draws the triangle and compares every pixel, its order and its weights with exact arithmetic.
void expect_exact(const Corners& corners, int width, int height) {
  const oracle::GridTriangle exact = oracle::to_grid(to_double(corners));
  Image<std::uint16_t> drawn(width, height, 0);
  std::int64_t previous = -1;
  rasterize_triangle(corners, width, height, [&](int x, int y, const Eigen::Vector3d& weights) {
    ++drawn(x, y);
    const std::int64_t position = std::int64_t{y} * width + x;
    ASSERT_GT(position, previous) << "pixels must come row by row, from left to right";
    previous = position;
    const auto truth = oracle::weights(exact, x, y);
    for (int i = 0; i < 3; ++i) {
      const long double exact_weight = truth[static_cast<std::size_t>(i)];
      ASSERT_LE(std::fabs(weights[i] - exact_weight), exact_weight * half_ulp)
          << "weight of corner " << i;
    }
    ASSERT_NEAR(weights.sum(), 1.0, 4e-16);
  });
  ASSERT_EQ(drawn, oracle::coverage({exact}, width, height))
      << "corners " << corners[0].transpose() << " | " << corners[1].transpose() << " | "
      << corners[2].transpose();
}

float on_grid(std::mt19937& random, int low, int high, int units) {
  return static_cast<float>(std::uniform_int_distribution<int>(low * units, high * units)(random)) /
         static_cast<float>(units);
}

TEST(stage02_rasterize_triangle, covers_what_exact_arithmetic_says) {
  std::mt19937 random(1);
  for (const int units :
       {1, 2, 8, 256, 1024}) {  // 1024: finer than the grid, so that snapping and its ties count
    for (int i = 0; i < 3000; ++i) {
      Corners corners;
      for (auto& corner : corners)
        corner = {on_grid(random, -8, 24, units), on_grid(random, -8, 20, units)};
      expect_exact(corners, 17, 13);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(stage02_rasterize_triangle, is_exact_out_to_its_bound) {
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i) {
    Corners corners;
    for (auto& corner : corners)
      corner = {on_grid(random, -32768, 32768, 256), on_grid(random, -32768, 32768, 256)};
    expect_exact(corners, 40, 30);
    if (HasFatalFailure()) return;
  }
  const float far = 32768;
  for (const Corners& corners : {Corners{{{-far, -far}, {far, -far}, {-far, far}}},
                                 Corners{{{-far, -far}, {far, far}, {-far, far}}},
                                 Corners{{{-far, -far}, {far, far}, {far, far - 1.0F / 256}}}}) {
    expect_exact(corners, 64, 64);
  }
}

TEST(stage02_rasterize_triangle, covers_the_same_whatever_the_order_of_its_corners) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    Corners corners;
    for (auto& corner : corners) corner = {on_grid(random, 0, 16, 2), on_grid(random, 0, 16, 2)};
    std::array<int, 3> order = {0, 1, 2};
    std::vector<Image<std::uint8_t>> drawn;
    do {
      Image<std::uint8_t> image(16, 16, 0);
      const auto at = [&](std::size_t k) { return corners[static_cast<std::size_t>(order[k])]; };
      rasterize_triangle({at(0), at(1), at(2)}, 16, 16,
                         [&](int x, int y, const Eigen::Vector3d&) { image(x, y) = 1; });
      drawn.push_back(image);
    } while (std::next_permutation(order.begin(), order.end()));
    for (const auto& image : drawn) ASSERT_EQ(image, drawn.front());
  }
}

TEST(stage02_rasterize_triangle, covers_nothing_without_area) {
  int visits = 0;
  const auto count = [&](int, int, const Eigen::Vector3d&) { ++visits; };
  rasterize_triangle({Eigen::Vector2f(1, 1), {5, 5}, {9, 9}}, 16, 16, count);
  rasterize_triangle({Eigen::Vector2f(1, 4.5F), {5, 4.5F}, {9, 4.5F}}, 16, 16, count);
  rasterize_triangle({Eigen::Vector2f(3.5F, 1), {3.5F, 12}, {3.5F, 4}}, 16, 16, count);
  rasterize_triangle({Eigen::Vector2f(2.5F, 2.5F), {2.5F, 2.5F}, {9, 2}}, 16, 16, count);
  rasterize_triangle({Eigen::Vector2f(2, 2), {9, 2}, {2, 9}}, 0, 0, count);
  EXPECT_EQ(visits, 0);
}

TEST(stage02_rasterize_triangle, refuses_what_it_cannot_do_exactly) {
  const auto ignore = [](int, int, const Eigen::Vector3d&) {};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {32768.5F, -40000.0F, std::numeric_limits<float>::infinity(), nan}) {
    EXPECT_THROW(rasterize_triangle({Eigen::Vector2f(0, 0), {bad, 0}, {0, 9}}, 16, 16, ignore),
                 CheckError)
        << bad;
    EXPECT_THROW(rasterize_triangle({Eigen::Vector2f(0, 0), {1, 0}, {0, bad}}, 16, 16, ignore),
                 CheckError)
        << bad;
  }
}

}  // namespace
}  // namespace rasterlab

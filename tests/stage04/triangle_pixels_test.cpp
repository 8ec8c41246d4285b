// What a covered pixel is told, against 113-bit arithmetic.
#include "common/projection/triangle_pixels.h"

#include "tests/stage04/random_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

__extension__ using Quad = __float128;

using QuadTriangle = std::array<std::array<Quad, 2>, 3>;

Quad twice_area(const std::array<Quad, 2>& a, const std::array<Quad, 2>& b,
                const std::array<Quad, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The truth for one triangle that needs no clipping: its corners snapped to 1/256 pixel.
struct Truth {
  QuadTriangle window;
  std::array<Quad, 3> w;
  std::array<Quad, 3> depth;

  Truth(const ClipTriangle& clip, int width, int height) {
    for (std::size_t i = 0; i < 3; ++i) {
      const WindowPoint point = to_window(clip[i], width, height);
      window[i] = {static_cast<Quad>(std::nearbyint(point.position.x() * 256)) / 256,
                   static_cast<Quad>(std::nearbyint(point.position.y() * 256)) / 256};
      w[i] = clip[i].w();
      depth[i] = point.depth;
    }
  }

  std::array<Quad, 3> window_weights(Quad x, Quad y) const {
    const std::array<Quad, 2> p = {x, y};
    const Quad area = twice_area(window[0], window[1], window[2]);
    return {twice_area(p, window[1], window[2]) / area, twice_area(window[0], p, window[2]) / area,
            twice_area(window[0], window[1], p) / area};
  }

  std::array<Quad, 3> weights(Quad x, Quad y) const {
    std::array<Quad, 3> result = window_weights(x, y);
    Quad sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += result[i] /= w[i];
    for (Quad& weight : result) weight /= sum;
    return result;
  }

  Quad depth_at(Quad x, Quad y) const {
    const auto at = window_weights(x, y);
    return at[0] * depth[0] + at[1] * depth[1] + at[2] * depth[2];
  }
};

struct Errors {
  double weight = 0;
  double depth = 0;
  double derivative = 0;  // relative to the largest derivative at that pixel
};

Errors errors_of(const ClipTriangle& clip, int width, int height) {
  const Truth truth(clip, width, height);
  Errors errors;
  const auto off = [](float actual, Quad expected) {
    return std::abs(static_cast<double>(static_cast<Quad>(actual) - expected));
  };
  for_each_pixel(clip, width, height, [&](const TrianglePixel& pixel) {
    const Quad x = pixel.x + Quad(0.5);
    const Quad y = pixel.y + Quad(0.5);
    const auto at = truth.weights(x, y);
    errors.weight =
        std::max({errors.weight, off(pixel.weights.b1, at[1]), off(pixel.weights.b2, at[2])});
    errors.depth = std::max(errors.depth, off(pixel.depth, truth.depth_at(x, y)));
    const Quad step = 0x1p-40;  // its error: step² times the third derivative
    const auto right = truth.weights(x + step, y);
    const auto left = truth.weights(x - step, y);
    const auto down = truth.weights(x, y + step);
    const auto up = truth.weights(x, y - step);
    const std::array<Quad, 4> expected = {
        (right[1] - left[1]) / (2 * step), (right[2] - left[2]) / (2 * step),
        (down[1] - up[1]) / (2 * step), (down[2] - up[2]) / (2 * step)};
    const std::array<float, 4> actual = {pixel.weights_dx.b1, pixel.weights_dx.b2,
                                         pixel.weights_dy.b1, pixel.weights_dy.b2};
    double largest = 1e-30;
    for (const Quad value : expected) {
      largest = std::max(largest, std::abs(static_cast<double>(value)));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      errors.derivative = std::max(errors.derivative, off(actual[i], expected[i]) / largest);
    }
  });
  return errors;
}

ClipTriangle random_triangle(RandomValues& random, float largest_w) {
  ClipTriangle clip;
  for (Eigen::Vector4f& corner : clip) {
    const float w = std::pow(largest_w, random.number(0, 1));
    corner = {random.number(-1, 1) * w, random.number(-1, 1) * w, random.number(-1, 1) * w, w};
  }
  return clip;
}

TEST(stage04_for_each_pixel, weights_and_depth_are_those_of_the_snapped_triangle) {
  RandomValues random(4077);
  Errors worst;
  for (int i = 0; i < 3000; ++i) {
    const Errors errors = errors_of(random_triangle(random, i % 2 == 0 ? 10.0F : 1e5F), 64, 48);
    worst.weight = std::max(worst.weight, errors.weight);
    worst.depth = std::max(worst.depth, errors.depth);
    worst.derivative = std::max(worst.derivative, errors.derivative);
  }
  EXPECT_LE(worst.weight, 6e-8) << "half of a float's last bit below 1";
  EXPECT_LE(worst.depth, 6e-8);
  EXPECT_LE(worst.derivative, 2e-7);
}

TEST(stage04_for_each_pixel, slivers_are_as_exact) {
  RandomValues random(4078);
  for (int i = 0; i < 3000; ++i) {
    ClipTriangle clip = random_triangle(random, 100);
    const float along = random.number(0, 1);
    const float w = clip[2].w();
    const Eigen::Vector4f on_edge =
        clip[0] / clip[0].w() * (1 - along) + clip[1] / clip[1].w() * along;
    clip[2] = on_edge * w +
              Eigen::Vector4f(random.number(-1, 1), random.number(-1, 1), 0, 0) * (w / 1000);
    clip[2].w() = w;
    const Errors errors = errors_of(clip, 64, 48);
    ASSERT_LE(errors.weight, 6e-8) << "case " << i;
    ASSERT_LE(errors.depth, 6e-8) << "case " << i;
  }
}

TEST(stage04_for_each_pixel, where_corners_are_equal_the_value_is_exactly_theirs) {
  const ClipTriangle clip = {Eigen::Vector4f(-1, -1, 0, 1), Eigen::Vector4f(5, -2, 1, 7),
                             Eigen::Vector4f(0, 3, 1, 4)};
  int pixels = 0;
  for_each_pixel(clip, 64, 48, [&](const TrianglePixel& pixel) {
    const std::array<float, 3> equal = {0.1F, 0.1F, 0.1F};
    const CornerWeights<float>& b = pixel.weights;
    EXPECT_EQ(equal[0] + (b.b1 * (equal[1] - equal[0]) + b.b2 * (equal[2] - equal[0])), 0.1F);
    ++pixels;
  });
  EXPECT_GT(pixels, 100);
}

TEST(stage04_for_each_pixel, a_clipped_triangle_keeps_the_weights_of_the_whole) {
  // A floor that goes on behind the eye: at each pixel, the point of the floor that is seen there.
  const std::array<Eigen::Vector3d, 3> corners = {
      Eigen::Vector3d(-3, -1, -4), Eigen::Vector3d(4, -1, -5), Eigen::Vector3d(0.5, -1, 6)};
  const double near = 0.1;
  ClipTriangle clip;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& p = corners[i];
    clip[i] = Eigen::Vector4d(p.x(), p.y(), -p.z() - 2 * near, -p.z()).cast<float>();
  }
  int pixels = 0;
  for_each_pixel(clip, 64, 64, [&](const TrianglePixel& pixel) {
    const double b1 = pixel.weights.b1;
    const double b2 = pixel.weights.b2;
    const Eigen::Vector3d seen =
        corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]);
    // The line of sight through the pixel's centre meets y = −1 there.
    const double ndc_x = (pixel.x + 0.5) / 32 - 1;
    const double ndc_y = 1 - (pixel.y + 0.5) / 32;
    const double distance = -1 / ndc_y;
    ASSERT_NEAR(seen.x(), ndc_x * distance, 2e-3 * distance);
    ASSERT_NEAR(-seen.z(), distance, 2e-3 * distance);
    ++pixels;
  });
  EXPECT_GT(pixels, 500);
}

TEST(stage04_for_each_pixel, fronts_go_counter_clockwise_and_mirrors_turn_that_round) {
  const ClipTriangle front = {Eigen::Vector4f(-1, -1, 0, 1), Eigen::Vector4f(1, -1, 0, 1),
                              Eigen::Vector4f(0, 1, 0, 1)};
  const ClipTriangle back = {front[1], front[0], front[2]};
  const auto is_drawn = [](const ClipTriangle& triangle, Cull cull, bool mirrored) {
    TriangleCounts counts;
    bool drawn = false;
    for_each_pixel(triangle, 16, 16, {.cull = cull, .mirrored = mirrored}, counts,
                   [&](const TrianglePixel&) { drawn = true; });
    EXPECT_EQ(counts.culled, drawn ? 0 : 1);
    return drawn;
  };
  EXPECT_TRUE(is_drawn(front, Cull::none, false));
  EXPECT_TRUE(is_drawn(back, Cull::none, false));
  EXPECT_TRUE(is_drawn(front, Cull::back, false));
  EXPECT_FALSE(is_drawn(back, Cull::back, false));
  EXPECT_FALSE(is_drawn(front, Cull::front, false));
  EXPECT_TRUE(is_drawn(back, Cull::front, false));
  EXPECT_FALSE(is_drawn(front, Cull::back, true));
  EXPECT_TRUE(is_drawn(back, Cull::back, true));
}

TEST(stage04_for_each_pixel, what_is_beyond_the_far_plane_is_not_there) {
  const ClipTriangle leaning = {Eigen::Vector4f(-1, -1, -1, 1), Eigen::Vector4f(1, -1, -1, 1),
                                Eigen::Vector4f(0, 1, 3, 1)};
  int lowest = 0;
  int highest = 64;
  for_each_pixel(leaning, 64, 64, [&](const TrianglePixel& pixel) {
    EXPECT_LE(pixel.depth, 1);
    lowest = std::max(lowest, pixel.y);
    highest = std::min(highest, pixel.y);
  });
  EXPECT_EQ(lowest, 63);
  EXPECT_EQ(highest, 32) << "depth reaches 1 half way up";
}

}  // namespace
}  // namespace rasterlab

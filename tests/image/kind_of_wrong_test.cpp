// Makes each mistake with pictures like those of the lab, and expects its name; makes mistakes that
// have no name, and expects none.
#include "common/image/kind_of_wrong.h"

#include "common/image/operations.h"

#include "tests/image/corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

struct Triangle {
  std::array<double, 3> x;
  std::array<double, 3> y;
  std::array<Color, 3> colors;
};

/// How the scene is drawn wrong: where it is, and what becomes of a colour.
struct Mistake {
  double dx = 0;
  double dy = 0;
  float factor = 1;
  float gamma = 1;
};

std::vector<Triangle> random_triangles(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  std::vector<Triangle> triangles(static_cast<std::size_t>(count));
  for (Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.x[i] = between(5, 95);
      triangle.y[i] = between(5, 75);
      triangle.colors[i] =
          Color(float(between(.1, 1)), float(between(.1, 1)), float(between(.1, 1)));
    }
  }
  return triangles;
}

void draw(const Triangle& t, const Mistake& mistake, Image<Rgb8>& image) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double px = x + 0.5 - mistake.dx;
      const double py = y + 0.5 - mistake.dy;
      std::array<double, 3> side{};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        side[i] = (t.x[k] - t.x[j]) * (py - t.y[j]) - (t.y[k] - t.y[j]) * (px - t.x[j]);
      }
      const double area = side[0] + side[1] + side[2];
      if (!(side[0] * area > 0 && side[1] * area > 0 && side[2] * area > 0)) continue;
      Color color = Color::Zero();
      for (std::size_t i = 0; i < 3; ++i) color += float(side[i] / area) * t.colors[i];
      color = (color * mistake.factor).array().min(1).pow(mistake.gamma);
      image(x, y) = to_rgb8(color);
    }
  }
}

Image<Rgb8> scene(unsigned seed, const Mistake& mistake = {}) {
  Image<Rgb8> image(100, 80);
  for (const Triangle& triangle : random_triangles(seed, 5)) draw(triangle, mistake, image);
  return image;
}

Image<Rgb8> transposed(const Image<Rgb8>& image) {
  Image<Rgb8> result(image.height(), image.width());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) result(y, x) = image(x, y);
  }
  return result;
}

constexpr unsigned scenes = 12;

TEST(stage01_kind_of_wrong, turned_over) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Image<Rgb8> right = scene(seed);
    EXPECT_EQ(kind_of_wrong(flipped_vertically(right), right), "flipped in y");
    EXPECT_EQ(kind_of_wrong(flipped_horizontally(right), right), "flipped in x");
    EXPECT_EQ(kind_of_wrong(flipped_horizontally(flipped_vertically(right)), right),
              "flipped in x and y");
    EXPECT_EQ(kind_of_wrong(transposed(right), right), "transposed");
    const Image<Rgb8> square = resized(right, 60, 60);
    EXPECT_EQ(kind_of_wrong(transposed(square), square), "transposed");
  }
}

TEST(stage01_kind_of_wrong, red_and_blue_swapped) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Image<Rgb8> right = scene(seed);
    Image<Rgb8> wrong = right;
    for (Rgb8& pixel : wrong.pixels()) std::swap(pixel.r, pixel.b);
    EXPECT_EQ(kind_of_wrong(wrong, right), "red and blue swapped");
  }
}

TEST(stage01_kind_of_wrong, shifted_by_a_pixel) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Image<Rgb8> right = scene(seed);
    EXPECT_EQ(kind_of_wrong(scene(seed, {.dx = 1}), right), "shifted by a pixel to the right");
    EXPECT_EQ(kind_of_wrong(scene(seed, {.dy = -1}), right), "shifted by a pixel up");
    EXPECT_EQ(kind_of_wrong(scene(seed, {.dx = -1, .dy = 1}), right),
              "shifted by a pixel to the left and a pixel down");
  }
}

/// Half a pixel is an estimate from what edges there are: it may be missed, but never misnamed.
TEST(stage01_kind_of_wrong, shifted_by_half_a_pixel) {
  const std::vector<std::pair<Mistake, std::string>> cases = {
      {{.dx = 0.5}, "shifted by half a pixel to the right"},
      {{.dy = 0.5}, "shifted by half a pixel down"},
      {{.dx = -0.5, .dy = -0.5}, "shifted by half a pixel to the left and half a pixel up"}};
  unsigned named = 0;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    for (const auto& [mistake, name] : cases) {
      const std::string said = kind_of_wrong(scene(seed, mistake), scene(seed));
      if (said == name) ++named;
      EXPECT_TRUE(said.empty() || said == name) << said << ", scene " << seed;
    }
  }
  EXPECT_GE(named, 32U) << "of 36";
}

TEST(stage01_kind_of_wrong, a_fine_pattern_shifted) {
  Image<std::uint8_t> right(40, 40);
  std::mt19937 random(1);
  for (std::uint8_t& pixel : right.pixels()) pixel = (random() & 1U) != 0 ? 255 : 0;
  Image<std::uint8_t> wrong(40, 40);
  for (int y = 0; y < 39; ++y) {
    for (int x = 0; x < 40; ++x) wrong(x, y + 1) = right(x, y);
  }
  EXPECT_EQ(kind_of_wrong(wrong, right), "shifted by a pixel down");
}

TEST(stage01_kind_of_wrong, too_bright_or_too_dark) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Image<Rgb8> right = scene(seed);
    EXPECT_THAT(kind_of_wrong(scene(seed, {.factor = 0.5F}), right),
                testing::StartsWith("too dark by a factor of 2"));
    EXPECT_THAT(kind_of_wrong(scene(seed, {.factor = 2}), right),
                testing::StartsWith("too bright by a factor of 2"));
    EXPECT_THAT(kind_of_wrong(right, scene(seed, {.factor = 0.8F})),
                testing::StartsWith("too bright by a factor of 1.25"));
  }
}

TEST(stage01_kind_of_wrong, gamma_applied) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    EXPECT_THAT(kind_of_wrong(scene(seed, {.gamma = 1 / 2.2F}), scene(seed)),
                testing::StartsWith("gamma applied (values to the power of 0.45"));
    EXPECT_THAT(kind_of_wrong(scene(seed, {.gamma = 2.2F}), scene(seed)),
                testing::StartsWith("gamma applied (values to the power of 2.2"));
  }
}

/// A sphere as a depth buffer sees it.
Image<float> sphere_depth(float nothing) {
  Image<float> depth(60, 50, nothing);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 60; ++x) {
      const float r2 = std::pow(float(x) - 31, 2.0F) + std::pow(float(y) - 22, 2.0F);
      if (r2 < 400) depth(x, y) = 3 - std::sqrt(400 - r2) / 20;
    }
  }
  return depth;
}

TEST(stage01_kind_of_wrong, depth_reversed) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float nothing : {infinity, 1.0F, 4.0F}) {
    const Image<float> right = sphere_depth(nothing);
    Image<float> negated = right;
    Image<float> exchanged = right;
    for (std::size_t i = 0; i < right.pixels().size(); ++i) {
      const float value = right.pixels()[i];
      if (value == nothing) continue;
      negated.pixels()[i] = -value;
      exchanged.pixels()[i] = 5 - value;
    }
    EXPECT_EQ(kind_of_wrong(exchanged, right), "depth reversed") << nothing;
    EXPECT_EQ(kind_of_wrong(negated, right), "depth reversed") << nothing;
  }
  const Image<std::uint8_t> grey = grey_picture(sphere_depth(4), 4, 2);
  Image<std::uint8_t> inverted = grey;
  for (std::uint8_t& pixel : inverted.pixels()) pixel = static_cast<std::uint8_t>(255 - pixel);
  EXPECT_EQ(kind_of_wrong(inverted, grey), "depth reversed");
}

TEST(stage01_kind_of_wrong, empty) {
  EXPECT_EQ(kind_of_wrong(Image<Rgb8>(100, 80), scene(1)), "empty");
  EXPECT_EQ(kind_of_wrong(Image<Rgb8>(100, 80, {9, 9, 9}), scene(1)), "empty");
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(kind_of_wrong(Image<float>(60, 50, infinity), sphere_depth(infinity)), "empty");
}

TEST(stage01_kind_of_wrong, what_has_no_name_gets_none) {
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Image<Rgb8> right = scene(seed);
    EXPECT_EQ(kind_of_wrong(scene(seed + 100), right), "") << seed;  // another picture
    EXPECT_EQ(kind_of_wrong(scene(seed, {.dx = 0.25}), right), "") << seed;
    std::mt19937 random(seed);
    Image<Rgb8> holes = right;
    for (Rgb8& pixel : holes.pixels()) {
      if (random() % 10 == 0) pixel = {};
    }
    EXPECT_EQ(kind_of_wrong(holes, right), "") << seed;
    Image<Rgb8> one_wrong = right;
    one_wrong(50, 40).g ^= 0x80U;
    EXPECT_EQ(kind_of_wrong(one_wrong, right), "") << seed;
  }
}

/// A triangle bounded by some of its sides, as where the third weight is not tested.
Image<Rgb8> bounded_by(std::initializer_list<int> sides) {
  const std::array<std::array<int, 2>, 3> corners = {{{12, 4}, {50, 14}, {20, 48}}};
  Image<Rgb8> image(60, 60);
  for (int y = 4; y <= 48; ++y) {
    for (int x = 12; x <= 50; ++x) {
      const bool covered = std::all_of(sides.begin(), sides.end(), [&](int side) {
        const auto& [ax, ay] = corners[static_cast<std::size_t>(side)];
        const auto& [bx, by] = corners[static_cast<std::size_t>((side + 1) % 3)];
        return (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0;
      });
      if (covered) image(x, y) = {255, 255, 255};
    }
  }
  return image;
}

TEST(stage01_kind_of_wrong, a_side_left_out_is_no_shift) {
  const Image<Rgb8> right = bounded_by({0, 1, 2});
  EXPECT_EQ(kind_of_wrong(bounded_by({0, 1}), right), "");
  EXPECT_EQ(kind_of_wrong(bounded_by({0, 2}), right), "");
  EXPECT_EQ(kind_of_wrong(bounded_by({1, 2}), right), "");
}

TEST(stage01_kind_of_wrong, small_and_strange_pictures) {
  EXPECT_EQ(kind_of_wrong(Image<Rgb8>(), Image<Rgb8>()), "");
  EXPECT_EQ(kind_of_wrong(Image<Rgb8>(1, 1), Image<Rgb8>(1, 1, {1, 1, 1})), "");
  EXPECT_EQ(kind_of_wrong(Image<Rgb8>(1, 2), Image<Rgb8>(3, 3)), "");
  Image<float> strange(7, 7, std::numeric_limits<float>::quiet_NaN());
  strange(3, 3) = -std::numeric_limits<float>::max();
  strange(4, 3) = 1;
  EXPECT_EQ(kind_of_wrong(flipped_horizontally(strange), strange), "flipped in x");
}

}  // namespace
}  // namespace rasterlab

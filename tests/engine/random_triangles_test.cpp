// Ten million random triangles: the engine covers exactly the pixels the exercise code covers.
#include "tests/engine/coverage_difference.h"

#include <random>

#include <gmock/gmock.h>
#include <rapidcheck.h>

namespace rasterlab {
namespace {

constexpr std::uint32_t triangles_per_picture = 20000;

/// Triangle i at depth −1 + i · step: all in front of the ones after it, each flat, so that which
/// is seen follows from coverage alone.
Mesh random_triangles(std::mt19937& random, std::uint32_t count) {
  const auto number = [&random] { return static_cast<float>(random() >> 8U) / 16777216.0F; };
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    // From hundredths of a pixel to the whole picture; most are a few pixels.
    const float reach = std::exp(-6.5F * std::sqrt(number()) + 0.3F);
    const float x = 2.4F * number() - 1.2F;
    const float y = 2.4F * number() - 1.2F;
    // Some on the grid of pixel centres and quarters, where boundaries meet samples.
    const bool on_grid = random() % 4 == 0;
    for (int c = 0; c < 3; ++c) {
      Eigen::Vector3f p(x + reach * (number() - 0.5F), y + reach * (number() - 0.5F),
                        -1.0F + 1.9F * static_cast<float>(i) / static_cast<float>(count));
      if (on_grid) {
        for (int axis = 0; axis < 2; ++axis) p[axis] = std::round(p[axis] * 512) / 512;
      }
      mesh.positions.push_back(p);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(engine_random_triangles, ten_million_cover_what_the_exercise_covers) {
  std::mt19937 random(5);
  Renderer renderer;
  for (int picture = 0; picture < 500; ++picture) {
    const Mesh mesh = random_triangles(random, triangles_per_picture);
    ASSERT_FALSE(coverage_differs(mesh, renderer))
        << "picture " << picture << ", " << culprit(mesh, renderer);
  }
}

}  // namespace

/// Corner coordinates in 1/512 pixel, so that half of them must be rounded.
struct GridTriangle {
  std::array<int, 6> coordinate;
};

void showValue(const GridTriangle& triangle, std::ostream& stream) {
  for (const int value : triangle.coordinate) stream << value << "/512 ";
}

namespace {

Mesh mesh_of(const std::vector<GridTriangle>& triangles) {
  constexpr float per_unit = 512.0F * coverage_side / 2;
  Mesh mesh;
  for (const GridTriangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const float z = static_cast<float>(mesh.triangles.size()) / 1024 - 1;
    for (std::size_t c = 0; c < 3; ++c) {
      mesh.positions.emplace_back(static_cast<float>(t.coordinate[2 * c]) / per_unit - 1,
                                  1 - static_cast<float>(t.coordinate[2 * c + 1]) / per_unit, z);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace
}  // namespace rasterlab

namespace rc {

/// A first corner in or near the picture; the others as far from it as a sample, a small triangle,
/// a large one or the guard band is wide. Shrinks towards the picture's corner.
template <>
struct Arbitrary<rasterlab::GridTriangle> {
  static Gen<rasterlab::GridTriangle> arbitrary() {
    const auto within = [](int reach) { return gen::inRange(-reach, reach + 1); };
    const auto offset =
        gen::oneOf(within(512), within(8 * 512), within(300 * 512), within(16000 * 512));
    const auto start = gen::inRange(-64, 320 * 512);
    return gen::map(gen::tuple(start, start, offset, offset, offset, offset), [](const auto& t) {
      const auto& [x, y, dx1, dy1, dx2, dy2] = t;
      return rasterlab::GridTriangle{{x, y, x + dx1, y + dy1, x + dx2, y + dy2}};
    });
  }
};

}  // namespace rc

namespace rasterlab {

namespace {

TEST(engine_random_triangles, any_few_triangles_cover_what_the_exercise_covers) {
  Renderer renderer({.threads = 1, .skip = {}});
  EXPECT_TRUE(rc::check([&](const std::vector<GridTriangle>& triangles) {
    return !coverage_differs(mesh_of(triangles), renderer);
  }));
}

}  // namespace
}  // namespace rasterlab

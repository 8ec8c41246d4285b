#include "common/zbuffer/visibility.h"

#include "tests/oracle/exact_visibility.h"

#include <cmath>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// How many pixels show another triangle than they should.
int wrong_winners(const VisibilityRung& rung, const VisibilityScene& scene,
                  const VisibleTriangles& truth) {
  const VisibleTriangles seen = rung.seen(scene);
  int wrong = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i)
    wrong += seen.pixels()[i] != truth.pixels()[i] ? 1 : 0;
  return wrong;
}

/// Large triangles at all distances, each crossing many others.
VisibilityScene random_scene(unsigned seed) {
  VisibilityScene scene{.width = 64, .height = 64, .near = 1, .far = 10, .triangles = {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-16, 80);
  std::uniform_real_distribution<float> distance(1, 10);
  for (int i = 0; i < 12; ++i) {
    VisibilityTriangle& triangle = scene.triangles.emplace_back();
    for (Eigen::Vector2f& corner : triangle.corners) corner = {place(random), place(random)};
    for (float& d : triangle.distances) d = distance(random);
  }
  return scene;
}

/// Two triangles of one shape, the second nearer by the part `gap` of its distance.
VisibilityScene pair_scene(float distance, double gap) {
  VisibilityScene scene{.width = 64, .height = 64, .near = 0.1F, .far = 1e5F, .triangles = {}};
  VisibilityTriangle triangle{
      {Eigen::Vector2f(1, 2), Eigen::Vector2f(63, 20), Eigen::Vector2f(10, 62)},
      {distance, 1.7F * distance, 2.3F * distance}};
  scene.triangles.push_back(triangle);
  for (float& d : triangle.distances) d = static_cast<float>(d * (1 - gap));
  scene.triangles.push_back(triangle);
  return scene;
}

const VisibilityRung& rung_named(const std::string& name) {
  for (const VisibilityRung& rung : visibility_ladder) {
    if (rung.name == name) return rung;
  }
  throw std::out_of_range(name);
}

TEST(stage03_visibility, a_float_buffer_shows_the_nearest) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const VisibilityScene scene = random_scene(seed);
    const VisibleTriangles truth = oracle::exactly_seen(scene);
    for (const char* name : {"zbuffer_24", "zbuffer_float", "zbuffer_reversed"}) {
      EXPECT_EQ(wrong_winners(rung_named(name), scene, truth), 0) << name << ", scene " << seed;
    }
  }
}

TEST(stage03_visibility, every_rung_sees_what_is_alone) {
  VisibilityScene scene = random_scene(7);
  scene.triangles.resize(1);
  const VisibleTriangles truth = oracle::exactly_seen(scene);
  for (const VisibilityRung& rung : visibility_ladder)
    EXPECT_EQ(wrong_winners(rung, scene, truth), 0) << rung.name;
}

TEST(stage03_visibility, of_equals_the_earlier_stays) {
  for (const VisibilityRung& rung : visibility_ladder) {
    if (std::string(rung.name) == "draw_order") continue;  // its fault
    const VisibilityScene scene = pair_scene(10, 0);
    EXPECT_EQ(wrong_winners(rung, scene, oracle::exactly_seen(scene)), 0) << rung.name;
  }
}

TEST(stage03_visibility, sorting_fails_where_triangles_cross) {
  int draw_order = 0;
  int painter = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const VisibilityScene scene = random_scene(seed);
    const VisibleTriangles truth = oracle::exactly_seen(scene);
    draw_order += wrong_winners(rung_named("draw_order"), scene, truth);
    painter += wrong_winners(rung_named("painter"), scene, truth);
  }
  EXPECT_GT(painter, 0) << "a rung's known fault must show";
  EXPECT_GT(draw_order, painter) << "sorting helps";
}

TEST(stage03_visibility, painter_is_right_where_nothing_overlaps_in_depth) {
  VisibilityScene scene = random_scene(8);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    for (float& d : scene.triangles[i].distances)
      d = static_cast<float>((i * 7) % 12) + 1 + 0.05F * d;
  }
  EXPECT_EQ(wrong_winners(rung_named("painter"), scene, oracle::exactly_seen(scene)), 0);
}

// A perspective camera's gaps over five decades of distance: fewer wrong winners the higher the
// rung, and reversed float none where the gap is 10 times a float's step.
TEST(stage03_visibility, nearly_coplanar_pairs_over_five_decades) {
  std::map<std::string, int> wrong;
  for (int decade = 0; decade < 5; ++decade) {
    for (int gap = 2; gap <= 7; ++gap) {
      const VisibilityScene scene =
          pair_scene(static_cast<float>(std::pow(10, decade)), std::pow(10, -gap));
      const VisibleTriangles truth = oracle::exactly_seen(scene);
      for (const VisibilityRung& rung : visibility_ladder) {
        const int count = wrong_winners(rung, scene, truth);
        wrong[rung.name] += count;
        if (gap <= 5 && std::string(rung.name) == "zbuffer_reversed") {
          EXPECT_EQ(count, 0) << "distance 1e" << decade << ", gap 1e-" << gap;
        }
      }
    }
  }
  EXPECT_GT(wrong["zbuffer_16"], wrong["zbuffer_24"]);
  EXPECT_GT(wrong["zbuffer_24"], wrong["zbuffer_reversed"]);
  EXPECT_GT(wrong["zbuffer_float"], 10 * wrong["zbuffer_reversed"]);
  for (const auto& [name, count] : wrong)
    std::printf("%s: %d wrong winners\n", name.c_str(), count);
}

}  // namespace
}  // namespace rasterlab

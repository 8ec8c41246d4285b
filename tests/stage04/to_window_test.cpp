#include "common/projection/draw_mesh.h"
#include "common/projection/perspective.h"
#include "common/projection/rotation.h"
#include "common/projection/vertex_stage.h"
#include "common/projection/viewport.h"

#include "tests/stage04/random_values.h"

#include <bit>
#include <cstdint>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

// Keeps the compiler from folding operations whose order is what is tested.
float opaque(float value) {
  volatile float kept = value;
  return kept;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

TEST(stage04_to_window, each_component_of_clip_space_is_summed_in_the_contracts_order) {
  RandomValues random(407);
  for (int i = 0; i < 10000; ++i) {
    Eigen::Matrix4f m;
    for (int k = 0; k < 16; ++k) m(k) = random.number(-3, 3);
    const Eigen::Vector3f p = random.vector(100);
    const Eigen::Vector4f clip = to_clip(m, p);
    for (int row = 0; row < 4; ++row) {
      float sum = opaque(opaque(m(row, 0) * p.x()) + opaque(m(row, 1) * p.y()));
      sum = opaque(sum + opaque(m(row, 2) * p.z()));
      sum = opaque(sum + m(row, 3));
      ASSERT_TRUE(same_bits(clip[row], sum)) << "component " << row << " of case " << i;
    }
  }
}

TEST(stage04_to_window, window_coordinates_are_computed_in_the_contracts_order) {
  RandomValues random(4071);
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector4f clip(random.number(-9, 9), random.number(-9, 9), random.number(-9, 9),
                               random.number(0.1F, 9));
    const int width = 1 + random.index(2000);
    const int height = 1 + random.index(2000);
    const WindowPoint point = to_window(clip, width, height);
    const float half_width = static_cast<float>(width) / 2;
    const float half_height = static_cast<float>(height) / 2;
    const float x = opaque(opaque(opaque(clip.x() / clip.w()) + 1) * half_width);
    const float y = opaque(opaque(1 - opaque(clip.y() / clip.w())) * half_height);
    ASSERT_TRUE(same_bits(point.position.x(), x)) << "divide by w, do not multiply by 1 / w";
    ASSERT_TRUE(same_bits(point.position.y(), y));
    ASSERT_TRUE(same_bits(point.depth, opaque(clip.z() / clip.w())));
  }
}

TEST(stage04_to_window, corners_of_a_picture_that_is_not_square) {
  EXPECT_EQ(to_window({-1, 1, 0, 1}, 64, 36).position, Eigen::Vector2f(0, 0)) << "top left";
  EXPECT_EQ(to_window({1, -1, 0, 1}, 64, 36).position, Eigen::Vector2f(64, 36)) << "bottom right";
  EXPECT_EQ(to_window({0, 0, 0, 1}, 63, 35).position, Eigen::Vector2f(31.5F, 17.5F))
      << "odd sides have their middle in the middle of a pixel";
}

TEST(stage04_to_window, everything_is_divided_by_w_once) {
  const WindowPoint point = to_window({2, 1, -2, 4}, 8, 8);
  EXPECT_EQ(point.position, Eigen::Vector2f(6, 3));
  EXPECT_EQ(point.depth, -0.5F);
}

TEST(stage04_to_window, is_where_the_viewport_matrix_puts_it) {
  const Eigen::Vector4f clip(0.3F, -0.7F, 0.2F, 1.7F);
  const Eigen::Vector3f window = (viewport(0, 0, 320, 200) * clip).hnormalized();
  EXPECT_LT((to_window(clip, 320, 200).position - window.head<2>()).norm(), 1e-4F);
}

TEST(stage04_to_window, model_then_view_then_projection) {
  Transforms transforms;
  transforms.model = rotation(90, {0, 0, 1});  // takes x to y
  transforms.view = translation({0, -1, -5});
  transforms.projection = perspective(90, 1, 0.1F, 20);
  // (1, 0, 0) → (0, 1, 0) → (0, 0, −5) → the middle.
  const Eigen::Vector4f clip = to_clip(transforms.to_clip(), {1, 0, 0});
  EXPECT_LT((to_window(clip, 100, 100).position - Eigen::Vector2f(50, 50)).norm(), 1e-4F);
  EXPECT_NEAR(clip.w(), 5, 1e-5);
}

TEST(stage04_to_window, matrices_are_multiplied_without_losing_a_far_away_camera) {
  Transforms transforms;
  transforms.model = translation({1e6F, 0, 0});
  transforms.view = translation({-1e6F, 0, 0});
  EXPECT_EQ(transforms.to_clip(), Eigen::Matrix4f::Identity());
}

}  // namespace
}  // namespace rasterlab

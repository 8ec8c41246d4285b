// Clusters that face away are left out as a whole, and no pixel knows of it: not even where
// snapping turns triangles over that are smaller than a pixel or seen edge on.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include <numbers>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

struct Drawn {
  Image<std::int32_t> ids;
  Image<float> depth;
  std::uint64_t facing_away = 0;
};

Drawn draw(const PreparedMesh& mesh, const Eigen::Matrix4f& matrix, Cull cull, bool skip) {
  Framebuffer frame(160, 120);
  Renderer renderer({.threads = 1, .skip = {.facing_away = skip}});
  const Statistics statistics =
      renderer.draw({.mesh = &mesh, .matrix = matrix, .cull = cull}, frame);
  return {frame.ids(), frame.depth(), statistics.clusters_facing_away};
}

/// Turned by `degrees` about the vertical axis, `distance` away; `flat`: without perspective.
Eigen::Matrix4f view(float degrees, float distance, bool flat) {
  Eigen::Matrix4f projection = Eigen::Matrix4f::Zero();
  projection(0, 0) = 1.2F;
  projection(1, 1) = 1.6F;
  projection(2, 2) = flat ? -0.01F : -1;
  projection(2, 3) = flat ? 0 : -0.2F;
  projection(3, flat ? 3 : 2) = flat ? distance : -1;
  Eigen::Affine3f camera = Eigen::Affine3f::Identity();
  camera.translate(Eigen::Vector3f(0.01F, 0.02F, -distance));
  camera.rotate(Eigen::AngleAxisf(degrees * std::numbers::pi_v<float> / 180,
                                  Eigen::Vector3f(0, 1, 0.01F).normalized()));
  return projection * camera.matrix();
}

/// A flat square of small triangles.
Mesh sheet(float size, int count) {
  Mesh mesh;
  for (int y = 0; y <= count; ++y) {
    for (int x = 0; x <= count; ++x) {
      const auto place = [&](int i) {
        return size * (static_cast<float>(i) / static_cast<float>(count) - 0.5F);
      };
      mesh.positions.emplace_back(place(x), place(y), 0.0F);
    }
  }
  const auto row = static_cast<std::uint32_t>(count) + 1;
  for (std::uint32_t y = 0; y + 1 < row; ++y) {
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t a = y * row + x;
      mesh.triangles.push_back({a, a + 1, a + row});
      mesh.triangles.push_back({a + 1, a + row + 1, a + row});
    }
  }
  return mesh;
}

/// Of all views, the number of clusters left out.
std::uint64_t expect_same_pixels(const Mesh& mesh, const std::vector<float>& turns) {
  const PreparedMesh prepared(mesh);
  std::uint64_t facing_away = 0;
  for (const float turn : turns) {
    for (const float distance : {1.5F, 4.0F, 20.0F}) {
      for (const bool flat : {false, true}) {
        for (const Cull cull : {Cull::back, Cull::front}) {
          const Eigen::Matrix4f matrix = view(turn, distance, flat);
          const Drawn skipped = draw(prepared, matrix, cull, true);
          const Drawn whole = draw(prepared, matrix, cull, false);
          EXPECT_EQ(skipped.ids, whole.ids) << "turned by " << turn << ", " << distance << " away";
          EXPECT_EQ(skipped.depth, whole.depth);
          EXPECT_EQ(whole.facing_away, 0U);
          facing_away += skipped.facing_away;
        }
      }
    }
  }
  return facing_away;
}

TEST(engine_facing_away, spheres_and_knots) {
  for (const char* shape : {"uv_sphere:60", "torus_knot:120"}) {
    EXPECT_GT(expect_same_pixels(make_shape(shape), {0, 30, 200}), 0U) << shape;
  }
}

TEST(engine_facing_away, sheets_edge_on) {
  const std::vector<float> turns = {0, 80, 88, 89.9F, 90, 90.1F, 92, 100, 180};
  for (const int count : {30, 120}) {
    EXPECT_GT(expect_same_pixels(sheet(1.2F, count), turns), 0U) << count << " a side";
  }
}

TEST(engine_facing_away, triangles_smaller_than_snapping_knows) {
  expect_same_pixels(sheet(0.02F, 60), {0, 60, 120, 180});
}

}  // namespace
}  // namespace rasterlab

// What a triangle looks like does not depend on which triangles are shaded in the same vector.
#include "common/engine/renderer.h"

#include "tests/engine/test_shaders.h"

#include <cstdlib>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int side = 192;

/// A large triangle behind many of a few pixels.
Mesh small_before_large(std::mt19937& random) {
  const auto number = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
  };
  Mesh mesh;
  mesh.positions = {{-1, -1, 0.5F}, {1, -1, 0.5F}, {0, 1, 0.5F}};
  for (int i = 0; i < 150; ++i) {
    const Eigen::Vector2f center(number(-0.9F, 0.9F), number(-0.9F, 0.9F));
    const float z = number(-0.5F, 0.3F);
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::Vector2f p =
          center + Eigen::Vector2f(number(-0.08F, 0.08F), number(-0.08F, 0.08F));
      mesh.positions.emplace_back(p.x(), p.y(), z);
    }
  }
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitZ());
  for (std::uint32_t i = 0; i < mesh.positions.size(); i += 3) {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

Framebuffer draw(const Mesh& mesh, SimdTarget simd) {
  const PreparedMesh prepared(mesh);
  const PlainShader shader;
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix(3, 0) = 0.3F;  // w differs from corner to corner
  Framebuffer frame(side, side);
  Renderer({.threads = 1, .simd = simd, .skip = {}})
      .draw({.mesh = &prepared, .matrix = matrix, .shading = shading(shader)}, frame);
  return frame;
}

int largest_difference(const Rgb8& a, const Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST(engine_neighbours, do_not_change_a_triangles_colors) {
  std::mt19937 random(11);
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    const Mesh mesh = small_before_large(random);
    const Framebuffer together = draw(mesh, simd);
    const Image<std::int32_t> ids = together.ids();
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      Mesh one = mesh;
      one.triangles = {mesh.triangles[triangle]};
      const Framebuffer alone = draw(one, simd);
      for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
        if (ids.pixels()[i] != static_cast<std::int32_t>(triangle)) continue;
        ASSERT_LE(largest_difference(together.color().pixels()[i], alone.color().pixels()[i]), 1)
            << "triangle " << triangle << ", pixel " << i;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab

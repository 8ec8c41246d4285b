// Input nobody should give, and somebody will.
#include "common/engine/renderer.h"
#include "common/image/check.h"
#include "common/mesh/shapes.h"

#include "tests/engine/test_shaders.h"

#include <limits>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Limits = std::numeric_limits<float>;

Eigen::Matrix4f some_matrix() {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix(2, 2) = -0.5F;
  matrix(3, 2) = -0.4F;
  matrix(3, 3) = 1.5F;
  return matrix;
}

Image<std::int32_t> draw(const Mesh& mesh, const EngineOptions& options) {
  const PreparedMesh prepared(mesh);
  Framebuffer frame(97, 61);
  const BusyShader shader;
  Renderer(options).draw({.mesh = &prepared, .matrix = some_matrix(), .shading = shading(shader)},
                         frame);
  return frame.ids();
}

TEST(engine_hostile, any_number_in_any_position) {
  const Mesh good = make_shape("icosphere:2");
  const Image<std::int32_t> whole = draw(good, {});
  for (const float value :
       {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
        Limits::lowest(), Limits::denorm_min(), -Limits::denorm_min(), Limits::min(), -0.0F}) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Mesh mesh = good;
      mesh.positions[7][axis] = value;
      const Image<std::int32_t> expected =
          draw(mesh, {.threads = 1, .simd = SimdTarget::scalar, .skip = {}});
      EXPECT_EQ(draw(mesh, {}), expected) << value << " on axis " << axis;
      if (std::isfinite(value)) continue;
      // Triangles that don't use the vertex are seen where they were, unless something is now seen
      // through the hole.
      const auto uses_vertex = [&](std::int32_t id) {
        const Mesh::Triangle& t = good.triangles[static_cast<std::size_t>(id)];
        return std::find(t.begin(), t.end(), 7U) != t.end();
      };
      for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        const std::int32_t id = whole.pixels()[i];
        if (id < 0 || uses_vertex(id)) continue;
        ASSERT_GE(expected.pixels()[i], 0);
      }
    }
  }
}

TEST(engine_hostile, matrices_that_lead_nowhere) {
  const Mesh mesh = make_shape("cube");
  const PreparedMesh prepared(mesh);
  for (const float value : {0.0F, Limits::quiet_NaN(), Limits::infinity(), Limits::max(), -1.0F}) {
    Framebuffer frame(40, 30);
    const BusyShader shader;
    const Eigen::Matrix4f matrix = Eigen::Matrix4f::Constant(value);
    Renderer().draw({.mesh = &prepared, .matrix = matrix, .shading = shading(shader)}, frame);
    EXPECT_THAT(frame.ids().pixels(), testing::Each(-1)) << value;
  }
}

TEST(engine_hostile, nothing_to_draw) {
  const Mesh mesh;
  const PreparedMesh prepared(mesh);
  Framebuffer frame(20, 10);
  frame.clear({1, 2, 3});
  Renderer().draw({.mesh = &prepared}, frame);
  EXPECT_THAT(frame.color().pixels(), testing::Each(Rgb8{1, 2, 3}));
  Framebuffer none(0, 0);
  const Mesh cube = make_shape("cube");
  const PreparedMesh prepared_cube(cube);
  Renderer().draw({.mesh = &prepared_cube}, none);
}

TEST(engine_hostile, index_out_of_range_is_refused) {
  Mesh mesh = make_shape("cube");
  mesh.triangles[3][1] = 99;
  try {
    PreparedMesh prepared(mesh);
    FAIL() << "must be refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("triangle 3 refers to vertex 99"));
  }
}

}  // namespace
}  // namespace rasterlab

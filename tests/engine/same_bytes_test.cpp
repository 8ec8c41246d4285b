// One input, one image: whatever the threads, the instruction set, the tile size, the skips and the
// order of a triangle's corners.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include "tests/engine/test_shaders.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

struct Pictures {
  Image<Rgb8> color;
  Image<std::int32_t> ids;
  Image<float> depth;
  friend bool operator==(const Pictures&, const Pictures&) = default;
};

Eigen::Matrix4f perspective_from(float distance) {
  const float near = 0.1F;
  Eigen::Matrix4f projection = Eigen::Matrix4f::Zero();
  projection(0, 0) = 1.2F;
  projection(1, 1) = 1.6F;
  projection(2, 2) = -1;
  projection(2, 3) = -2 * near;
  projection(3, 2) = -1;
  Eigen::Affine3f view = Eigen::Affine3f::Identity();
  view.translate(Eigen::Vector3f(0.05F, 0.1F, -distance));
  view.rotate(Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 0.5F).normalized()));
  return projection * view.matrix();
}

template <class Shader>
Pictures draw(const Mesh& mesh, const EngineOptions& options, int tile_size, float distance) {
  const PreparedMesh prepared(mesh);
  Framebuffer frame(333, 251, tile_size);
  frame.clear({10, 20, 30});
  Renderer renderer(options);
  const Shader shader;
  renderer.draw(
      {.mesh = &prepared, .matrix = perspective_from(distance), .shading = shading(shader)}, frame);
  return {frame.color(), frame.ids(), frame.depth()};
}

Mesh rotated_corners(Mesh mesh, int by) {
  for (Mesh::Triangle& t : mesh.triangles) std::rotate(t.begin(), t.begin() + by, t.end());
  return mesh;
}

class engine_same_bytes : public testing::TestWithParam<float> {
 protected:
  template <class Shader>
  void check_all() {
    for (const char* shape : {"torus_knot:24", "uv_sphere:100", "wall:1"}) {
      SCOPED_TRACE(shape);
      check<Shader>(make_shape(shape));
    }
  }

  template <class Shader>
  void check(const Mesh& mesh) {
    const float distance = GetParam();
    const Pictures expected =
        draw<Shader>(mesh, {.threads = 1, .simd = SimdTarget::scalar}, 64, distance);
    EXPECT_THAT(expected.ids.pixels(), testing::Contains(testing::Ge(0)));
    for (const SimdTarget simd : supported_simd_targets()) {
      SCOPED_TRACE(name_of(simd));
      for (const int tile_size : {16, 32, 64}) {
        EXPECT_EQ(draw<Shader>(mesh, {.threads = 3, .simd = simd}, tile_size, distance), expected)
            << "tiles of " << tile_size;
      }
    }
    EXPECT_EQ(draw<Shader>(mesh, {.threads = 1}, 64, distance), expected);
    const Skips nothing = {false, false, false, false, false};
    EXPECT_EQ(draw<Shader>(mesh, {.skip = nothing}, 64, distance), expected);
    for (const int by : {1, 2}) {
      EXPECT_EQ(draw<Shader>(rotated_corners(mesh, by), {}, 64, distance), expected)
          << "corners rotated by " << by;
    }
  }
};

TEST_P(engine_same_bytes, shaded) {
  check_all<BusyShader>();
}
TEST_P(engine_same_bytes, discarding) {
  check_all<HolesShader>();
}
TEST_P(engine_same_bytes, plain_scalar_shader) {
  check_all<PlainShader>();
}

INSTANTIATE_TEST_SUITE_P(, engine_same_bytes, testing::Values(3.0F, 1.2F, 0.5F));

}  // namespace
}  // namespace rasterlab

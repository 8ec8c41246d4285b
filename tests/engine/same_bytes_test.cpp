// One input, one image: whatever the threads, the instruction set, the tile size, the skips and the
// order of a triangle's corners.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include "tests/engine/test_shaders.h"

#include <algorithm>
#include <random>

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
Framebuffer draw(const PreparedMesh& mesh, const EngineOptions& options, int tile_size,
                 float distance, Keep keep) {
  Framebuffer frame(333, 251, tile_size);
  frame.clear({10, 20, 30});
  Renderer renderer(options);
  const Shader shader;
  renderer.draw({.mesh = &mesh,
                 .matrix = perspective_from(distance),
                 .shading = shading(shader),
                 .keep = keep},
                frame);
  return frame;
}

template <class Shader>
Pictures draw(const Mesh& mesh, const EngineOptions& options, int tile_size, float distance) {
  const Framebuffer frame =
      draw<Shader>(PreparedMesh(mesh), options, tile_size, distance, Keep::everything);
  return {frame.color(), frame.ids(), frame.depth()};
}

Mesh rotated_corners(Mesh mesh, int by) {
  for (Mesh::Triangle& t : mesh.triangles) std::rotate(t.begin(), t.begin() + by, t.end());
  return mesh;
}

/// Each of them twice, so that the earlier one must win everywhere. A tile of 64 pixels has
/// hundreds of them, one of 16 a few dozen.
Mesh slivers() {
  std::mt19937 random(3);
  const auto number = [&random] { return static_cast<float>(random() >> 8U) / 8388608.0F - 1; };
  Mesh mesh;
  for (std::uint32_t i = 0; i < 1200; ++i) {
    const Eigen::Vector3f from(number(), number(), number());
    const Eigen::Vector3f along = 0.5F * Eigen::Vector3f(number(), number(), number());
    const Eigen::Vector3f across = 0.01F * Eigen::Vector3f(number(), number(), number());
    mesh.positions.insert(mesh.positions.end(), {from, from + along, from + across});
    mesh.normals.insert(mesh.normals.end(), 3, along.normalized());
    mesh.triangles.insert(mesh.triangles.end(), 2, {3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  return mesh;
}

/// Triangles of any size up to the picture's, which cut each other, and some twice: blocks that one
/// has, that several share, and that several compete for.
Mesh crossing_triangles() {
  std::mt19937 random(5);
  const auto number = [&random] { return static_cast<float>(random() >> 8U) / 8388608.0F - 1; };
  const auto place = [&] { return Eigen::Vector3f(number(), number(), number()); };
  Mesh mesh;
  for (std::uint32_t i = 0; i < 120; ++i) {
    const float size = i % 3 == 0 ? 1.0F : 0.2F;
    const Eigen::Vector3f center = place();
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(center + size * place());
      mesh.normals.push_back(place().normalized());
    }
    mesh.triangles.insert(mesh.triangles.end(), i % 4 == 0 ? 2 : 1, {3 * i, 3 * i + 1, 3 * i + 2});
  }
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
    {
      SCOPED_TRACE("slivers");
      check<Shader>(slivers());
    }
    SCOPED_TRACE("crossing triangles");
    check<Shader>(crossing_triangles());
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
    Skips nothing = no_skips();
    EXPECT_EQ(draw<Shader>(mesh, {.skip = nothing}, 64, distance), expected);
    nothing.hidden_fragments = true;  // else all are drawn one way
    EXPECT_EQ(draw<Shader>(mesh, {.skip = nothing}, 64, distance), expected);
    for (const int by : {1, 2}) {
      EXPECT_EQ(draw<Shader>(rotated_corners(mesh, by), {}, 64, distance), expected)
          << "corners rotated by " << by;
    }
    check_kept<Shader>(PreparedMesh(mesh), expected);
  }

  /// What a draw call keeps is the same, whatever else it keeps, and the rest can't be had.
  template <class Shader>
  void check_kept(const PreparedMesh& mesh, const Pictures& expected) {
    for (const bool skip : {true, false}) {
      const EngineOptions options = {.threads = 3, .skip = {.unwanted_depth = skip}};
      Framebuffer depth = draw<Shader>(mesh, options, 32, GetParam(), Keep::depth);
      EXPECT_EQ(depth.color(), expected.color);
      EXPECT_EQ(depth.depth(), expected.depth);
      EXPECT_THROW(depth.ids(), CheckError);
      EXPECT_THROW(Renderer(options).draw({.mesh = &mesh}, depth), CheckError);
      const Framebuffer color = draw<Shader>(mesh, options, 64, GetParam(), Keep::color);
      EXPECT_EQ(color.color(), expected.color);
      EXPECT_THROW(color.depth(), CheckError);
      EXPECT_THROW(color.distance(Eigen::Matrix4f::Identity()), CheckError);
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

/// Triangles are drawn without their numbers then.
TEST_P(engine_same_bytes, depth_alone) {
  for (const char* shape : {"torus_knot:24", "uv_sphere:100", "wall:1"}) {
    SCOPED_TRACE(shape);
    const Mesh plain = make_shape(shape);
    const PreparedMesh mesh(plain);
    const auto depth_kept = [&](Keep keep, SimdTarget simd) {
      Framebuffer frame(333, 251);
      Renderer renderer({.simd = simd});
      const Eigen::Matrix4f matrix = perspective_from(GetParam());
      renderer.draw({.mesh = &mesh, .matrix = matrix, .keep = keep}, frame);
      return frame.depth();
    };
    const Image<float> expected = depth_kept(Keep::everything, SimdTarget::scalar);
    for (const SimdTarget simd : supported_simd_targets()) {
      EXPECT_EQ(depth_kept(Keep::depth, simd), expected) << name_of(simd);
    }
  }
}

/// Blocks that no two triangles compete for have no depths, and show and keep the same.
TEST_P(engine_same_bytes, undisputed_blocks) {
  const auto check = [](const Mesh& plain) {
    const PreparedMesh mesh(plain);
    const BusyShader shader;
    std::uint64_t undisputed = 0;
    const auto kept = [&](Keep keep, const EngineOptions& options, int tile_size) {
      Framebuffer frame(333, 251, tile_size);
      const Statistics done = Renderer(options).draw({.mesh = &mesh,
                                                      .matrix = perspective_from(GetParam()),
                                                      .shading = shading(shader),
                                                      .keep = keep},
                                                     frame);
      undisputed += done.blocks_undisputed;
      return frame;
    };
    const Framebuffer expected = kept(Keep::everything, {.simd = SimdTarget::scalar}, 64);
    EXPECT_EQ(undisputed, 0U);
    for (const SimdTarget simd : supported_simd_targets()) {
      SCOPED_TRACE(name_of(simd));
      for (const int tile_size : {16, 32, 64}) {
        EXPECT_EQ(kept(Keep::color, {.simd = simd}, tile_size).color(), expected.color());
        EXPECT_EQ(kept(Keep::depth, {.simd = simd}, tile_size).depth(), expected.depth());
      }
      EXPECT_GT(std::exchange(undisputed, 0), 0U);
    }
    const EngineOptions without = {.skip = {.undisputed_blocks = false}};
    EXPECT_EQ(kept(Keep::color, without, 64).color(), expected.color());
    EXPECT_EQ(undisputed, 0U);
  };
  check(crossing_triangles());
  for (const char* shape : {"uv_sphere:8", "wall:1"}) {
    SCOPED_TRACE(shape);
    check(make_shape(shape));
  }
}

/// What was drawn before stays, and no tile is lost between two ways of keeping.
TEST_P(engine_same_bytes, last_draw_call_keeps_less) {
  const Mesh plain_knot = make_shape("torus_knot:24");
  const Mesh plain_sphere = make_shape("uv_sphere:100");
  const PreparedMesh knot(plain_knot);
  const PreparedMesh sphere(plain_sphere);
  const Eigen::Matrix4f matrix = perspective_from(GetParam());
  const BusyShader shader;
  const auto both = [&](Keep keep) {
    Framebuffer frame(333, 251);
    frame.clear({10, 20, 30});
    Renderer renderer;
    renderer.draw({.mesh = &knot, .matrix = matrix, .shading = shading(shader)}, frame);
    renderer.draw({.mesh = &sphere, .matrix = matrix, .shading = shading(shader), .keep = keep},
                  frame);
    frame.clear({10, 20, 30});
    renderer.draw({.mesh = &sphere, .matrix = matrix, .shading = shading(shader)}, frame);
    renderer.draw({.mesh = &knot, .matrix = matrix, .shading = shading(shader), .keep = keep},
                  frame);
    return frame.color();
  };
  EXPECT_EQ(both(Keep::color), both(Keep::everything));
}

INSTANTIATE_TEST_SUITE_P(, engine_same_bytes, testing::Values(3.0F, 1.2F, 0.5F));

}  // namespace
}  // namespace rasterlab

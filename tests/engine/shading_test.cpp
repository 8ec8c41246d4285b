// Which pixels are shaded, how often, and what a shader may say to that.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include "tests/engine/test_shaders.h"

#include <random>
#include <set>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int width = 200;
constexpr int height = 150;

/// w grows with y, so that nothing is linear in the window.
Eigen::Matrix4f tilted() {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix(3, 1) = 0.4F;
  return matrix;
}

/// `count` squares of a grid's triangles, each nearer than the one before.
Mesh stack(int count, float side) {
  const Mesh grid = make_shape("wall", 4);
  Mesh mesh;
  for (int layer = 0; layer < count; ++layer) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const float z = 0.5F - 0.05F * static_cast<float>(layer);
    for (const Eigen::Vector3f& p : grid.positions) {
      mesh.positions.emplace_back(side * p.x(), side * p.y(), z);
      mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
    }
    for (const auto& [a, b, c] : grid.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return mesh;
}

template <class Shader>
Statistics draw(const Mesh& mesh, const Shader& shader, SimdTarget simd, Framebuffer& frame) {
  const PreparedMesh prepared(mesh);
  return Renderer({.threads = 2, .simd = simd, .skip = {}})
      .draw({.mesh = &prepared, .matrix = tilted(), .shading = shading(shader)}, frame);
}

int drawn_pixels(const Framebuffer& frame) {
  const Image<std::int32_t> ids = frame.ids();
  return static_cast<int>(
      std::count_if(ids.pixels().begin(), ids.pixels().end(), [](int id) { return id >= 0; }));
}

TEST(engine_shading, asks_the_shader_once_for_each_visible_pixel) {
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    std::atomic<int> asked = 0;
    Framebuffer frame(width, height);
    const Statistics statistics = draw(stack(8, 1), CountingShader(asked), simd, frame);
    const int visible = drawn_pixels(frame);
    EXPECT_GT(visible, width * height / 8);
    EXPECT_EQ(asked, visible) << "eight layers lie behind each other";
    EXPECT_EQ(statistics.pixels_shaded, static_cast<std::uint64_t>(visible));
  }
}

TEST(engine_shading, gives_a_plain_scalar_shader_what_a_wide_one_gets) {
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    const Mesh mesh = make_shape("torus_knot", 10);
    std::atomic<int> asked = 0;
    Framebuffer plain(width, height);
    Framebuffer wide(width, height);
    draw(mesh, CountingShader(asked), simd, plain);
    draw(mesh, StripesShader(), simd, wide);
    EXPECT_GT(asked, 1000);
    EXPECT_EQ(plain.color(), wide.color());
  }
}

TEST(engine_shading, leaves_color_and_depth_where_the_shader_discards) {
  const Mesh behind = stack(1, 1);
  Mesh before = stack(1, 0.8F);
  for (Eigen::Vector3f& p : before.positions) p.z() -= 0.3F;
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    Framebuffer both(width, height);
    Framebuffer only_behind(width, height);
    Framebuffer only_before(width, height);
    draw(behind, StripesShader(), simd, both);
    draw(before, HolesShader(), simd, both);
    draw(behind, StripesShader(), simd, only_behind);
    draw(before, HolesShader(), simd, only_before);
    const Image<std::int32_t> kept = only_before.ids();
    int holes = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const bool is_kept = kept(x, y) >= 0;
        const Framebuffer& expected = is_kept ? only_before : only_behind;
        ASSERT_EQ(both.color()(x, y), expected.color()(x, y)) << x << ", " << y;
        holes += is_kept ? 0 : 1;
      }
    }
    const Image<float> depth = both.depth();
    const Image<float> depth_behind = only_behind.depth();
    const Image<float> depth_before = only_before.depth();
    for (std::size_t i = 0; i < depth.pixels().size(); ++i) {
      const Image<float>& expected = kept.pixels()[i] >= 0 ? depth_before : depth_behind;
      ASSERT_EQ(depth.pixels()[i], expected.pixels()[i]) << "pixel " << i;
    }
    EXPECT_GT(holes, 3000);
    EXPECT_GT(drawn_pixels(only_before), 3000);
  }
}

/// Triangles that are the same all over are shaded as a whole.
TEST(engine_shading, colors_a_triangle_without_varyings_as_its_corners_say) {
  const Mesh mesh = stack(3, 1);
  ASSERT_LT(mesh.triangles.size(), 256U);
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    Framebuffer frame(width, height);
    draw(mesh, NumberedShader(), simd, frame);
    const Image<std::int32_t> ids = frame.ids();
    std::set<int> seen;
    int white = 0;
    for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
      const int id = ids.pixels()[i];
      if (id < 0) continue;
      const int code = frame.color().pixels()[i].r;
      ASSERT_NE(id % 5, 0) << "pixel " << i << " isn't drawn";
      if (id % 3 == 0 && code == 255) {
        ++white;
      } else {
        ASSERT_EQ(code, id) << "pixel " << i;
      }
      seen.insert(id);
    }
    EXPECT_GT(white, 100);
    EXPECT_GT(seen.size(), 20U);
  }
}

/// Also of clipped ones: the eye is amid the knot's tubes.
TEST(engine_shading, tells_a_triangle_without_varyings_which_side_is_seen) {
  const Mesh mesh = make_shape("torus_knot", 24);
  const PreparedMesh prepared(mesh);
  for (const bool mirrored : {false, true}) {
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix(0, 0) = mirrored ? -1 : 1;
    matrix.row(3) << 0, 0, -1, 0.3F;
    matrix.row(2) << 0, 0, -1, 0.2F;
    const auto picture = [&](bool corners_differ, SimdTarget simd) {
      const TwoSidedShader shader = {corners_differ};
      Framebuffer frame(width, height);
      const Statistics statistics = Renderer({.simd = simd})
                                        .draw({.mesh = &prepared,
                                               .matrix = matrix,
                                               .mirrored = mirrored,
                                               .shading = shading(shader)},
                                              frame);
      EXPECT_GT(statistics.triangles_clipped, 20U);
      return frame.color();
    };
    const Image<Rgb8> expected = picture(true, SimdTarget::scalar);
    const auto& pixels = expected.pixels();
    const auto fronts = [](const Rgb8& p) { return p.r > 0 && p.r < 128; };
    EXPECT_GT(std::count_if(pixels.begin(), pixels.end(), fronts), 500);
    EXPECT_GT(std::count_if(pixels.begin(), pixels.end(), [](const Rgb8& p) { return p.r > 128; }),
              500);
    for (const SimdTarget simd : supported_simd_targets()) {
      EXPECT_EQ(picture(false, simd), expected) << name_of(simd);
    }
  }
}

/// Crumbs of a pixel or two in front of triangles that are far larger than the picture or reach
/// behind the eye, which is at the origin and looks along z.
Mesh crumbs(int count) {
  std::mt19937 random(3);
  const auto number = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
  };
  Mesh mesh;
  const auto add = [&](Eigen::Vector2f center, float reach, float near, float far) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.triangles.push_back({first, first + 1, first + 2});
    for (int corner = 0; corner < 3; ++corner) {
      const float z = number(near, far);
      const Eigen::Vector2f p =
          center + Eigen::Vector2f(number(-reach, reach), number(-reach, reach));
      mesh.positions.emplace_back(z * p.x(), z * p.y(), z);
      mesh.normals.emplace_back(number(0, 1), number(0, 1), number(0, 1));
    }
  };
  for (int i = 0; i < count; ++i) {
    add({number(-1, 1), number(-1, 1)}, 0.09F, 1, 2);
    if (i % 100 == 0) add({number(-1, 1), number(-1, 1)}, 12, 2, 5);
    if (i % 150 == 25) add({number(-1, 1), number(-1, 1)}, 1, -1, 9);
  }
  return mesh;
}

/// That mesh with one triangle, and the others of no area.
Mesh alone(const Mesh& mesh, int triangle) {
  Mesh one = mesh;
  for (auto& corners : one.triangles) corners.fill(0);
  one.triangles[static_cast<std::size_t>(triangle)] =
      mesh.triangles[static_cast<std::size_t>(triangle)];
  return one;
}

/// Blocks that see about as many triangles as they have pixels are shaded in another way.
TEST(engine_shading, gives_a_pixel_its_color_whoever_its_neighbors_are) {
  constexpr int side = 40;
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.row(2) << 0, 0, 1, -0.4F;
  matrix.row(3) << 0, 0, 1, 0;
  const Mesh mesh = crumbs(2000);
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    Renderer renderer({.threads = 1, .simd = simd});
    const auto drawn = [&](const Mesh& which, Framebuffer& frame) {
      const PreparedMesh prepared(which);
      const PatchworkShader shader;
      return renderer.draw({.mesh = &prepared, .matrix = matrix, .shading = shading(shader)},
                           frame);
    };
    Framebuffer frame(side, side);
    const Statistics statistics = drawn(mesh, frame);
    EXPECT_GT(statistics.triangles_clipped, 2U);
    const Image<std::int32_t> ids = frame.ids();
    const std::set<int> seen(ids.pixels().begin(), ids.pixels().end());
    EXPECT_GT(seen.size(), 300U);
    EXPECT_EQ(statistics.pixels_shaded, static_cast<std::uint64_t>(drawn_pixels(frame)));
    for (const int triangle : seen) {
      if (triangle < 0) continue;
      Framebuffer by_itself(side, side);
      drawn(alone(mesh, triangle), by_itself);
      for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
        if (ids.pixels()[i] != triangle) continue;
        ASSERT_EQ(frame.color().pixels()[i], by_itself.color().pixels()[i])
            << "pixel " << i << ", triangle " << triangle;
      }
    }
  }
}

/// A frame that a shader broke off gives no depth, of which some was never written.
TEST(engine_shading, hands_on_what_a_shader_throws) {
  const Mesh mesh = stack(3, 1);
  const PreparedMesh prepared(mesh);
  const FailingShader shader = {{true}};
  Framebuffer frame(width, height);
  Renderer renderer({.threads = 2});
  for (const Keep keep : {Keep::everything, Keep::depth}) {
    const DrawCall call = {
        .mesh = &prepared, .matrix = tilted(), .shading = shading(shader), .keep = keep};
    EXPECT_THROW(renderer.draw(call, frame), std::runtime_error);
    EXPECT_THROW(frame.depth(), CheckError);
    EXPECT_THROW(renderer.draw({.mesh = &prepared}, frame), CheckError);
    frame.clear();
    renderer.draw({.mesh = &prepared, .matrix = tilted()}, frame);
    EXPECT_GT(drawn_pixels(frame), 3000);
    frame.clear();
  }
}

}  // namespace
}  // namespace rasterlab

// Each switch of Skips: it changes no pixel, and what it spares is counted.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include "tests/engine/test_shaders.h"

#include <algorithm>
#include <array>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int width = 512;
constexpr int height = 128;
constexpr int used_width = 192;  ///< but for what reaches beyond, less than 128 pixels
constexpr int tile_size = 16;

/// Triangles in window coordinates, in 1/256 pixel. All are there in NDC as they are: both sides of
/// the picture are powers of two.
class Crowd {
 public:
  explicit Crowd(unsigned seed) : random_(seed) {}

  int within(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }

  struct Corner {
    int x, y;
  };
  Corner anywhere() { return {within(0, used_width * 256), within(0, height * 256)}; }
  Corner sample() {
    return {within(0, used_width - 1) * 256 + 128, within(0, height - 1) * 256 + 128};
  }
  Corner near(Corner c, int reach) {
    return {within(c.x - reach, c.x + reach), within(c.y - reach, c.y + reach)};
  }

  void add(Corner a, Corner b, Corner c) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const Corner& corner : {a, b, c}) {
      mesh_.positions.emplace_back(static_cast<float>(corner.x) / (128 * width) - 1,
                                   1 - static_cast<float>(corner.y) / (128 * height),
                                   static_cast<float>(within(-90, 90)) / 100);
      mesh_.normals.emplace_back(
          Eigen::Vector3f(static_cast<float>(within(-9, 9)), 1, static_cast<float>(within(-9, 9)))
              .normalized());
    }
    mesh_.triangles.push_back({first, first + 1, first + 2});
  }

  Mesh take() { return std::move(mesh_); }

 private:
  std::mt19937 random_;
  Mesh mesh_;
};

/// Of all sizes, in front of each other.
void add_seen(Crowd& crowd) {
  for (const int size : {600, 3000, 12000, 30000}) {
    for (int i = 0; i < 40; ++i) {
      const Crowd::Corner a = crowd.anywhere();
      crowd.add(a, crowd.near(a, size), crowd.near(a, size));
    }
  }
}

constexpr int count_without_area = 150;

/// Points and lines, through samples as well.
void add_without_area(Crowd& crowd) {
  for (int i = 0; i < count_without_area; ++i) {
    const Crowd::Corner a = i % 2 == 0 ? crowd.sample() : crowd.anywhere();
    const int size = std::array{0, 1, 40, 700, 2500}[static_cast<std::size_t>(i % 5)];
    const int dx = crowd.within(-size, size);
    const int dy = i % 3 == 0 ? dx : crowd.within(-size, size);
    const int third = crowd.within(-3, 3);
    crowd.add(a, {a.x + 4 * dx, a.y + 4 * dy}, {a.x + third * dx, a.y + third * dy});
  }
}

constexpr int count_between_samples = 150;

/// In a pixel, or long ones in a row or a column of them, beside the samples.
void add_between_samples(Crowd& crowd) {
  for (int i = 0; i < count_between_samples; ++i) {
    const Crowd::Corner center = crowd.sample();
    const int along = std::array{110, 2000, 9000}[static_cast<std::size_t>(i % 3)];
    const bool flat = i % 2 == 0;
    const auto corner = [&](int part) {
      const int across = crowd.within(10, 240);
      const int way = part * along / 2 + crowd.within(1, 15);
      return flat ? Crowd::Corner{center.x + way, center.y + across}
                  : Crowd::Corner{center.x + across, center.y + way};
    };
    crowd.add(corner(0), corner(1), corner(2));
  }
}

Mesh crowd() {
  Crowd crowd(7);
  add_seen(crowd);
  add_without_area(crowd);
  add_between_samples(crowd);
  return crowd.take();
}

struct Drawn {
  Image<Rgb8> color;
  Image<std::int32_t> ids;
  Image<float> depth;
  Statistics statistics;

  bool shows_the_same(const Drawn& other) const {
    return color == other.color && ids == other.ids && depth == other.depth;
  }
};

template <class Shader = BusyShader>
Drawn draw(const PreparedMesh& mesh, const EngineOptions& options, Cull cull = Cull::none,
           const Eigen::Matrix4f& matrix = Eigen::Matrix4f::Identity()) {
  Framebuffer frame(width, height, tile_size);
  frame.clear({10, 20, 30});
  const Shader shader;
  const Statistics statistics = Renderer(options).draw(
      {.mesh = &mesh, .matrix = matrix, .cull = cull, .shading = shading(shader)}, frame);
  return {frame.color(), frame.ids(), frame.depth(), statistics};
}

EngineOptions without(bool Skips::*skip, SimdTarget simd = best_simd_target()) {
  EngineOptions options = {.threads = 2, .simd = simd, .skip = {}};
  options.skip.*skip = false;
  return options;
}

std::uint64_t visible_pixels(const Drawn& drawn) {
  return static_cast<std::uint64_t>(std::count_if(
      drawn.ids.pixels().begin(), drawn.ids.pixels().end(), [](int id) { return id >= 0; }));
}

class engine_skips : public testing::Test {
 protected:
  const Mesh plain_ = crowd();
  const PreparedMesh mesh_{plain_};
};

TEST_F(engine_skips, change_no_pixel) {
  const auto check = [&](Cull cull, const std::vector<SimdTarget>& targets) {
    const Drawn expected = draw(mesh_, {}, cull);
    const Drawn holes = draw<HolesShader>(mesh_, {}, cull);
    ASSERT_GT(visible_pixels(expected), std::uint64_t{used_width * height / 2});
    for (const NamedSkip& one : named_skips) {
      for (const SimdTarget simd : targets) {
        SCOPED_TRACE(std::string(name_of(simd)) + " without " + one.name);
        EXPECT_TRUE(draw(mesh_, without(one.skip, simd), cull).shows_the_same(expected));
        EXPECT_TRUE(draw<HolesShader>(mesh_, without(one.skip, simd), cull).shows_the_same(holes));
      }
    }
  };
  check(Cull::none, supported_simd_targets());
  check(Cull::back, supported_simd_targets());
  check(Cull::front, {best_simd_target()});
}

/// In perspective, from a place among the triangles: many are cut by the near plane.
Eigen::Matrix4f from_the_midst() {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.row(2) << 0, 0, -1, -0.02F;
  matrix.row(3) << 0, 0, -1, 0;
  return matrix;
}

TEST_F(engine_skips, change_no_pixel_of_what_is_clipped) {
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    const Drawn expected = draw(mesh_, {}, cull, from_the_midst());
    ASSERT_GT(expected.statistics.triangles_clipped, 20U);
    for (const NamedSkip& one : named_skips) {
      SCOPED_TRACE(one.name);
      EXPECT_TRUE(draw(mesh_, without(one.skip), cull, from_the_midst()).shows_the_same(expected));
    }
  }
}

TEST_F(engine_skips, skipped_vertices_are_counted) {
  const Eigen::Matrix4f beside = Eigen::Affine3f(Eigen::Translation3f(9, 0, 0)).matrix();
  for (const Cull cull : {Cull::none, Cull::back}) {
    EngineOptions options;
    options.skip.hidden_clusters = false;  // how many are depends on the threads
    const Statistics with = draw(mesh_, options, cull, beside).statistics;
    EXPECT_EQ(with.vertices, 0U);
    EXPECT_GE(with.vertices_skipped, plain_.positions.size());
    options.skip.skipped_vertices = false;
    const Statistics off = draw(mesh_, options, cull, beside).statistics;
    EXPECT_EQ(off.vertices_skipped, 0U);
    EXPECT_EQ(off.vertices, with.vertices_skipped);
  }
}

TEST_F(engine_skips, back_faces_are_counted) {
  for (const auto& matrix : {Eigen::Matrix4f::Identity().eval(), from_the_midst()}) {
    const Statistics with = draw(mesh_, {}, Cull::back, matrix).statistics;
    const Statistics off = draw(mesh_, without(&Skips::back_faces), Cull::back, matrix).statistics;
    EXPECT_GT(with.triangles_culled, 50U);
    EXPECT_EQ(off.triangles_culled, 0U);
    EXPECT_GT(off.triangles_binned, with.triangles_binned);
  }
}

TEST_F(engine_skips, attributes_a_shader_does_not_read_are_counted) {
  constexpr int numbers = 6;
  const Drawn with = draw<QuietShader>(mesh_, {});
  EXPECT_EQ(with.statistics.derivatives_unread, 2 * numbers * with.statistics.pixels_shaded);
  const Drawn undeclared = draw<UndeclaredShader>(mesh_, {});
  EXPECT_EQ(undeclared.statistics.derivatives_unread, 0U);
  EXPECT_TRUE(undeclared.shows_the_same(with));
  const Drawn off = draw<QuietShader>(mesh_, without(&Skips::unread_attributes));
  EXPECT_EQ(off.statistics.derivatives_unread, 0U);
  EXPECT_TRUE(off.shows_the_same(with));
}

TEST_F(engine_skips, zero_area_is_counted) {
  const Statistics with = draw(mesh_, {}).statistics;
  const Statistics off = draw(mesh_, without(&Skips::zero_area)).statistics;
  EXPECT_GE(with.triangles_without_area, std::uint64_t{count_without_area});
  EXPECT_EQ(off.triangles_without_area, 0U);
  EXPECT_GT(off.triangles_binned, with.triangles_binned);
}

TEST_F(engine_skips, missed_samples_are_counted) {
  const Statistics with = draw(mesh_, {}).statistics;
  const Statistics off = draw(mesh_, without(&Skips::missed_samples)).statistics;
  EXPECT_GE(with.triangles_missed, std::uint64_t{count_between_samples});
  EXPECT_LT(off.triangles_missed, with.triangles_missed - count_between_samples / 2);
  EXPECT_GT(off.triangles_binned, with.triangles_binned + count_between_samples / 2);
}

TEST_F(engine_skips, hidden_fragments_are_counted) {
  const Drawn with = draw(mesh_, {});
  EXPECT_EQ(with.statistics.pixels_shaded, visible_pixels(with));
  const Drawn off = draw(mesh_, without(&Skips::hidden_fragments));
  EXPECT_GT(off.statistics.pixels_shaded, visible_pixels(with));
}

TEST_F(engine_skips, a_shader_that_discards_is_asked_before_pixels_are_drawn) {
  const Drawn with = draw<HolesShader>(mesh_, {});
  EXPECT_EQ(with.statistics.pixels_shaded, visible_pixels(with));
  EXPECT_GT(with.statistics.pixels_asked, visible_pixels(with));
  EXPECT_EQ(draw<HolesShader>(mesh_, without(&Skips::hidden_fragments)).statistics.pixels_asked, 0U)
      << "they get their colours at once";
  EXPECT_EQ(draw(mesh_, {}).statistics.pixels_asked, 0U);
}

TEST_F(engine_skips, untouched_tiles_are_counted) {
  constexpr int all = width / tile_size * (height / tile_size);
  constexpr int empty = (width - used_width - 128) / tile_size * (height / tile_size);
  const Statistics with = draw(mesh_, {}).statistics;
  EXPECT_GE(with.tiles_untouched, std::uint64_t{empty});
  EXPECT_EQ(with.tiles_drawn + with.tiles_untouched, std::uint64_t{all});
  const Statistics off = draw(mesh_, without(&Skips::untouched_tiles)).statistics;
  EXPECT_EQ(off.tiles_untouched, 0U);
  EXPECT_EQ(off.tiles_drawn, std::uint64_t{all});
}

TEST_F(engine_skips, hidden_parts_of_triangles_are_counted) {
  EXPECT_GT(draw(mesh_, {}).statistics.blocks_hidden, 0U);
  EXPECT_EQ(draw(mesh_, without(&Skips::hidden_triangles)).statistics.blocks_hidden, 0U);
}

/// Once a tile has a picture, it must not get its background again.
TEST_F(engine_skips, untouched_tiles_keep_what_an_earlier_call_drew) {
  const BusyShader shader;
  const Mesh nothing;
  const PreparedMesh empty(nothing);
  const Image<Rgb8> expected = draw(mesh_, {}).color;
  for (const EngineOptions& options :
       {EngineOptions(), without(&Skips::untouched_tiles), without(&Skips::hidden_fragments)}) {
    Framebuffer frame(width, height, tile_size);
    frame.clear({10, 20, 30});
    Renderer renderer(options);
    renderer.draw({.mesh = &mesh_, .shading = shading(shader)}, frame);
    renderer.draw({.mesh = &empty, .shading = shading(shader)}, frame);
    EXPECT_EQ(frame.color(), expected);
  }
}

struct Colors {
  Image<Rgb8> color;
  Statistics statistics;
};

/// Of what is drawn only the colours are kept.
Colors draw_colors(const PreparedMesh& mesh, const EngineOptions& options, Cull cull,
                   const Eigen::Matrix4f& matrix) {
  const BusyShader shader;
  Framebuffer frame(width, height, tile_size);
  const Statistics statistics = Renderer(options).draw({.mesh = &mesh,
                                                        .matrix = matrix,
                                                        .cull = cull,
                                                        .shading = shading(shader),
                                                        .keep = Keep::color},
                                                       frame);
  return {frame.color(), statistics};
}

/// Beyond the picture's sides.
Eigen::Matrix4f enlarged(float depth_scale) {
  return Eigen::Vector4f(1.5F, 1.5F, depth_scale, 1).asDiagonal();
}

/// What one of the skips spares is counted, and nothing when it is switched off.
void expect_counted(const PreparedMesh& mesh, const Eigen::Matrix4f& matrix, Cull cull,
                    bool Skips::*skip, std::uint64_t Statistics::*count) {
  const Colors with = draw_colors(mesh, {}, cull, matrix);
  const Colors off = draw_colors(mesh, without(skip), cull, matrix);
  const std::string name = std::ranges::find(named_skips, skip, &NamedSkip::skip)->name;
  EXPECT_GT(with.statistics.*count, 0U) << name;
  EXPECT_EQ(off.statistics.*count, 0U) << name;
  EXPECT_EQ(off.color, with.color) << name;
}

TEST_F(engine_skips, what_is_not_kept_is_counted) {
  const auto check = [&](bool Skips::*skip, std::uint64_t Statistics::*count) {
    expect_counted(mesh_, Eigen::Matrix4f::Identity(), Cull::none, skip, count);
  };
  check(&Skips::unwanted_depth, &Statistics::tiles_not_kept);
  check(&Skips::undisputed_blocks, &Statistics::blocks_undisputed);
}

/// Of more triangles than one batch has, some in front of others.
class engine_skips_of_a_knot : public testing::Test {
 protected:
  const Mesh plain_ = make_shape("torus_knot", 80);
  const PreparedMesh mesh_{plain_};
};

TEST_F(engine_skips_of_a_knot, clusters_and_triangles_are_counted) {
  const auto check = [&](Cull cull, bool Skips::*skip, std::uint64_t Statistics::*count) {
    expect_counted(mesh_, enlarged(0.5F), cull, skip, count);
  };
  check(Cull::none, &Skips::outside, &Statistics::clusters_outside);
  check(Cull::back, &Skips::facing_away, &Statistics::clusters_facing_away);
  check(Cull::none, &Skips::hidden_clusters, &Statistics::clusters_hidden);
  check(Cull::none, &Skips::hidden_triangles, &Statistics::triangles_hidden);
}

/// Whichever end of it the clusters begin with.
TEST_F(engine_skips_of_a_knot, more_is_hidden_front_to_back) {
  const auto hidden = [&](EngineOptions options) {
    options.threads = 1;
    std::uint64_t clusters = 0;
    for (const float depth_scale : {0.5F, -0.5F}) {
      clusters +=
          draw_colors(mesh_, options, Cull::none, enlarged(depth_scale)).statistics.clusters_hidden;
    }
    return clusters;
  };
  EXPECT_GT(hidden({}), hidden(without(&Skips::front_to_back)));
}

}  // namespace
}  // namespace rasterlab

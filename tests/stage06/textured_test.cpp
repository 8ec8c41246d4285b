#include "common/lighting/shading.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/vertex_stage.h"
#include "common/texture/perspective_ladder.h"
#include "common/texture/textured_mesh.h"
#include "common/texture/textured_triangle.h"
#include "common/triangles/fixed_point.h"

#include <cmath>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// Each texel has a colour of its own, which says where it is.
Image<Rgb8> map_of_itself(int size) {
  Image<Rgb8> image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      image(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(size - 1 - y), 255};
    }
  }
  return image;
}

constexpr int side = 64;
using Uvs = std::array<Eigen::Vector2f, 3>;
using ExactCorners = std::array<Eigen::Vector4d, 3>;

/// Corners in front of the eye, moved to where the convention has them: in the window they snap to
/// 1/256 pixel, and attributes are interpolated from there.
ExactCorners snapped(const ClipTriangle& corners) {
  ExactCorners exact;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2f window = to_window(corners[i], side, side).position;
    const auto on_grid = [](float pixels) { return static_cast<double>(snap(pixels)) / subpixels; };
    const double w = corners[i].w();
    exact[i] = {(2 * on_grid(window.x()) / side - 1) * w, (1 - 2 * on_grid(window.y()) / side) * w,
                corners[i].z(), w};
  }
  return exact;
}

/// The weights with which the ray through a pixel's centre meets the triangle's plane, whatever the
/// signs of w, by one linear system in double precision: Σ bᵢ (xᵢ − X wᵢ) = Σ bᵢ (yᵢ − Y wᵢ) = 0
/// and Σ bᵢ = 1.
Eigen::Vector3d weights_of_ray(const ExactCorners& corners, int x, int y) {
  const double ndc_x = 2 * (x + 0.5) / side - 1;
  const double ndc_y = 1 - 2 * (y + 0.5) / side;
  Eigen::Matrix3d system;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector4d& corner = corners[static_cast<std::size_t>(i)];
    system.col(i) << corner.x() - ndc_x * corner.w(), corner.y() - ndc_y * corner.w(), 1;
  }
  return system.fullPivLu().solve(Eigen::Vector3d::UnitZ());
}

/// Draws the triangle with a texture that says which texel is where, and compares with the rays
/// that meet `exact`: each texel shown has the exact (u, v) within it, but for `slack` texels.
/// Returns how many pixels were compared.
int expect_exact_texels(const ClipTriangle& corners, const ExactCorners& exact, const Uvs& uv,
                        double slack) {
  const Texture texture(map_of_itself(256), MipLevels::none);
  Frame frame = make_frame(side, side);
  draw_textured_triangle(corners, uv, {.texture = &texture, .filter = Filter::nearest},
                         &perspective_weights, frame);
  int compared = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (frame.color(x, y).b == 0) continue;
      const Eigen::Vector3d weights = weights_of_ray(exact, x, y);
      const Eigen::Vector2d texel =
          256 * (weights[0] * uv[0].cast<double>() + weights[1] * uv[1].cast<double>() +
                 weights[2] * uv[2].cast<double>());
      EXPECT_NEAR(frame.color(x, y).r + 0.5, texel.x(), 0.5 + slack) << x << ", " << y;
      EXPECT_NEAR(frame.color(x, y).g + 0.5, texel.y(), 0.5 + slack) << x << ", " << y;
      ++compared;
    }
  }
  return compared;
}

TEST(stage06_draw_textured_triangle, exact_rung_agrees_with_rays) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> ndc(-0.9F, 0.9F);
  std::uniform_real_distribution<float> log_w(-1, 1);
  std::uniform_real_distribution<float> part(0, 1);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    ClipTriangle corners;
    Uvs uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const float w = std::pow(10.0F, log_w(random));
      corners[k] = {ndc(random) * w, ndc(random) * w, 0, w};
      uv[k] = {part(random), part(random)};
    }
    compared += expect_exact_texels(corners, snapped(corners), uv, 1e-3);
  }
  EXPECT_GT(compared, 50000);
}

TEST(stage06_draw_textured_triangle, what_is_behind_the_eye_is_cut_and_the_rest_is_right) {
  const Uvs uv = {Eigen::Vector2f(0.1F, 0.1F), Eigen::Vector2f(0.9F, 0.1F),
                  Eigen::Vector2f(0.5F, 0.9F)};
  const ClipTriangle corners = {Eigen::Vector4f(-0.5F, -0.5F, 0, 1),
                                Eigen::Vector4f(0.5F, -0.5F, 0, 1), Eigen::Vector4f(0, 1, 0, -1)};
  const ExactCorners exact = {corners[0].cast<double>(), corners[1].cast<double>(),
                              corners[2].cast<double>()};
  // Corners 0 and 1 are on the grid; those of the cut, far away, are moved by up to 1/512 pixel.
  EXPECT_GT(expect_exact_texels(corners, exact, uv, 0.05), side * side * 9 / 16);
}

TEST(stage06_draw_textured_triangle, nearer_wins_in_any_order) {
  Image<Rgb8> red(1, 1, {255, 0, 0});
  Image<Rgb8> green(1, 1, {0, 255, 0});
  const Texture near_texture(red);
  const Texture far_texture(green);
  const Uvs uv = {Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
  const auto triangle = [](float z) {
    return ClipTriangle{Eigen::Vector4f(-3, -3, z, 1), Eigen::Vector4f(3, -3, z, 1),
                        Eigen::Vector4f(0, 3, z, 1)};
  };
  for (const bool near_first : {true, false}) {
    Frame frame = make_frame(4, 4);
    for (const bool near : {near_first, !near_first}) {
      draw_textured_triangle(triangle(near ? -0.5F : 0.5F), uv,
                             {.texture = near ? &near_texture : &far_texture}, &affine_weights,
                             frame);
    }
    EXPECT_EQ(frame.color(2, 2), red(0, 0));
  }
}

// Along the diagonal of a square seen in perspective, affine interpolation breaks: two triangles,
// two textures. The exact rung sees no diagonal.
TEST(stage06_draw_textured_triangle, only_affine_rungs_know_of_the_diagonal) {
  const Texture texture(map_of_itself(256), MipLevels::none);
  // Repeated, the border would blend the first column with the last, whose texels are 255 apart.
  const Sampler sampler = {.texture = &texture, .filter = Filter::bilinear, .wrap = Wrap::clamp};
  const Mesh wall = make_shape("wall", 1);
  const Transforms transforms = {.view = look_at({1.6F, 0.2F, 1}, {0.2F, 0, 0}, {0, 1, 0}),
                                 .projection = perspective(60, 1, 0.1F, 20)};
  const auto draw = [&](const Mesh& mesh, PerspectiveRung rung) {
    Frame frame = make_frame(side, side);
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto clip = [&](std::uint32_t vertex) {
        return to_clip(transforms.to_clip(), mesh.positions[vertex]);
      };
      const auto& uv = mesh.texture_coordinates;
      draw_textured_triangle({clip(a), clip(b), clip(c)}, {uv[a], uv[b], uv[c]}, sampler, rung,
                             frame);
    }
    return frame.color;
  };
  Mesh other_diagonal = wall;  // the same square, cut the other way
  const auto find = [&](float x, float y) {
    for (std::uint32_t i = 0; i < wall.positions.size(); ++i) {
      if (wall.positions[i].x() == x && wall.positions[i].y() == y) return i;
    }
    throw std::runtime_error("the wall has no such corner");
  };
  const std::uint32_t sw = find(-1, -1);
  const std::uint32_t se = find(1, -1);
  const std::uint32_t ne = find(1, 1);
  const std::uint32_t nw = find(-1, 1);
  const bool rising = (wall.triangles[0] == Mesh::Triangle{sw, se, ne} ||
                       wall.triangles[0] == Mesh::Triangle{se, ne, sw} ||
                       wall.triangles[0] == Mesh::Triangle{ne, sw, se});
  other_diagonal.triangles = rising ? std::vector<Mesh::Triangle>{{sw, se, nw}, {se, ne, nw}}
                                    : std::vector<Mesh::Triangle>{{sw, se, ne}, {sw, ne, nw}};
  const auto largest_difference = [&](PerspectiveRung rung) {
    const Image<Rgb8> a = draw(wall, rung);
    const Image<Rgb8> b = draw(other_diagonal, rung);
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
      const Rgb8& one = a.pixels()[i];
      const Rgb8& other = b.pixels()[i];
      EXPECT_EQ(one.b, other.b) << "the outline has no diagonal";
      largest = std::max({largest, std::abs(one.r - other.r), std::abs(one.g - other.g)});
    }
    return largest;
  };
  EXPECT_LE(largest_difference(&perspective_weights), 1);
  EXPECT_GT(largest_difference(&affine_weights), 40);
}

Sampler constant(const Texture& texture) {
  return {.texture = &texture};
}

TEST(stage06_draw_textured_mesh, with_one_colour_it_is_stage_05s_picture) {
  const Rgb8 color{180, 90, 45};
  const Texture texture(Image<Rgb8>(5, 3, color));
  Mesh sphere = make_shape("uv_sphere", 16);
  Frame expected = make_frame(80, 60);
  Frame actual = make_frame(80, 60);
  LitMesh lit_mesh = {.mesh = sphere,
                      .transforms = {.view = look_at({1, 1, 3}, {0, 0, 0}, {0, 1, 0}),
                                     .projection = perspective(40, 4.0F / 3, 0.1F, 20)},
                      .light = {.position = {1, 2, 3, 1}},
                      .material = {}};
  lit_mesh.color = to_color(color);
  const DrawCounts expected_counts = shade_phong(lit_mesh, expected);
  const DrawCounts counts = draw_textured_mesh(lit_mesh, constant(texture), actual);
  EXPECT_EQ(counts.pixels, expected_counts.pixels);
  EXPECT_EQ(actual.depth.depths(), expected.depth.depths());
  for (std::size_t i = 0; i < actual.color.pixels().size(); ++i) {
    const Rgb8& a = actual.color.pixels()[i];
    const Rgb8& b = expected.color.pixels()[i];
    EXPECT_LE(std::abs(a.r - b.r), 1);
    EXPECT_LE(std::abs(a.g - b.g), 1);
    EXPECT_LE(std::abs(a.b - b.b), 1);
  }
}

TEST(stage06_draw_textured_mesh, the_texture_stands_upright) {
  Image<Rgb8> corners(2, 2);
  corners(0, 0) = {255, 0, 0};
  corners(1, 0) = {0, 255, 0};
  corners(0, 1) = {0, 0, 255};
  corners(1, 1) = {255, 255, 0};
  const Texture texture(corners);
  const Mesh wall = make_shape("wall", 1);
  Frame frame = make_frame(9, 9);
  draw_textured_mesh({.mesh = wall,
                      .transforms = {.view = look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}),
                                     .projection = perspective(30, 1, 0.1F, 20)},
                      .light = {},
                      .material = {.ambient = 1, .diffuse = 0, .specular = 0}},
                     {.texture = &texture, .filter = Filter::nearest}, frame);
  EXPECT_EQ(frame.color(0, 0), corners(0, 0));
  EXPECT_EQ(frame.color(8, 0), corners(1, 0));
  EXPECT_EQ(frame.color(0, 8), corners(0, 1));
  EXPECT_EQ(frame.color(8, 8), corners(1, 1));
}

// Each level has a grey of its own; what the exact derivatives ask for is what is seen.
TEST(stage06_draw_textured_mesh, reads_the_level_of_the_exact_derivatives) {
  Image<Rgb8> rows(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool white = (x % 2 == 0) == (y % 2 == 0);
      rows(x, y) = white ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
    }
  }
  const Texture texture(rows);
  const Mesh wall = make_shape("wall", 1);
  for (const int pixels : {256, 128, 64, 32, 16}) {
    Frame frame = make_frame(pixels, pixels);
    // Seen so that the square of side 2 fills the picture.
    const Transforms transforms = {.projection = Eigen::Matrix4f::Identity()};
    draw_textured_mesh({.mesh = wall,
                        .transforms = transforms,
                        .light = {},
                        .material = {.ambient = 1, .diffuse = 0, .specular = 0}},
                       {.texture = &texture, .filter = Filter::mip_mapped}, frame);
    const bool is_grey = frame.color(5, 7) == Rgb8{128, 128, 128};
    EXPECT_EQ(is_grey, pixels <= 32) << "two texels a pixel and more are all one grey: " << pixels;
  }
}

TEST(stage06_draw_textured_mesh, needs_texture_coordinates) {
  Mesh sphere = make_shape("icosphere", 1);
  sphere.texture_coordinates.clear();
  const Texture texture(Image<Rgb8>(1, 1));
  Frame frame = make_frame(4, 4);
  EXPECT_THROW(draw_textured_mesh({.mesh = sphere, .transforms = {}, .light = {}, .material = {}},
                                  constant(texture), frame),
               InputError);
}

}  // namespace
}  // namespace rasterlab

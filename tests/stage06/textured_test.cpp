#include "common/lighting/shading.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/vertex_stage.h"
#include "common/texture/perspective_ladder.h"
#include "common/texture/textured_mesh.h"
#include "common/texture/textured_triangle.h"

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

/// The weights with which the ray through a pixel's centre meets the triangle's plane, whatever the
/// signs of w, by one linear system in double precision: Σ bᵢ (xᵢ − X wᵢ) = Σ bᵢ (yᵢ − Y wᵢ) = 0
/// and Σ bᵢ = 1.
Eigen::Vector3d weights_of_ray(const ClipTriangle& corners, int x, int y, int width, int height) {
  const double ndc_x = 2 * (x + 0.5) / width - 1;
  const double ndc_y = 1 - 2 * (y + 0.5) / height;
  Eigen::Matrix3d system;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector4d corner = corners[static_cast<std::size_t>(i)].cast<double>();
    system.col(i) << corner.x() - ndc_x * corner.w(), corner.y() - ndc_y * corner.w(), 1;
  }
  return system.fullPivLu().solve(Eigen::Vector3d::UnitZ());
}

constexpr int side = 64;
using Uvs = std::array<Eigen::Vector2f, 3>;

/// Draws the triangle with a texture that says which texel is where, and compares with the ray.
/// Returns how many pixels were compared.
int expect_exact_texels(const ClipTriangle& corners, const Uvs& uv) {
  const Texture texture(map_of_itself(256), MipLevels::none);
  Frame frame = make_frame(side, side);
  draw_textured_triangle(corners, uv, {.texture = &texture, .filter = Filter::nearest},
                         &perspective_weights, frame);
  int compared = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (frame.color(x, y).b == 0) continue;
      const Eigen::Vector3d weights = weights_of_ray(corners, x, y, side, side);
      if (weights.minCoeff() < 1e-3) continue;  // snapping moves edges
      const Eigen::Vector2d exact = weights[0] * uv[0].cast<double>() +
                                    weights[1] * uv[1].cast<double>() +
                                    weights[2] * uv[2].cast<double>();
      EXPECT_NEAR(frame.color(x, y).r, exact.x() * 256 - 0.5, 0.5 + 0.7) << x << ", " << y;
      EXPECT_NEAR(frame.color(x, y).g, exact.y() * 256 - 0.5, 0.5 + 0.7) << x << ", " << y;
      ++compared;
    }
  }
  return compared;
}

TEST(stage06_draw_textured_triangle, what_is_behind_the_eye_is_cut_and_the_rest_is_right) {
  const Uvs uv = {Eigen::Vector2f(0.1F, 0.1F), Eigen::Vector2f(0.9F, 0.1F),
                  Eigen::Vector2f(0.5F, 0.9F)};
  const ClipTriangle corners = {Eigen::Vector4f(-0.5F, -0.5F, 0, 1),
                                Eigen::Vector4f(0.5F, -0.5F, 0, 1), Eigen::Vector4f(0, 1, 0, -1)};
  EXPECT_GT(expect_exact_texels(corners, uv), side * side * 9 / 16);
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

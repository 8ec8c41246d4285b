#include "06_texture/figures.h"

#include "common/image/files.h"
#include "common/image/operations.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/vertex_stage.h"
#include "common/projection/viewport.h"
#include "common/stage/given_files.h"
#include "common/texture/perspective_ladder.h"
#include "common/texture/sample.h"
#include "common/texture/textured_mesh.h"
#include "common/texture/textured_triangle.h"
#include "common/viewer/figure.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace rasterlab {
namespace {

/// A letter that no mirror leaves alone, its top left corner red, its bottom right one blue.
Image<Rgb8> letter() {
  const std::vector<std::string> rows = {"r.......",  //
                                         "..####..",  //
                                         "..#.....",  //
                                         "..###...",  //
                                         "..#.....",  //
                                         "..#.....",  //
                                         "..#.....",  //
                                         ".......b"};
  Image<Rgb8> image(8, 8, {255, 240, 200});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const char pixel = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      if (pixel == '#') image(x, y) = {40, 60, 90};
      if (pixel == 'r') image(x, y) = {220, 40, 40};
      if (pixel == 'b') image(x, y) = {40, 80, 220};
    }
  }
  return image;
}

}  // namespace

// 06.1: the square from (−1, −1) to (2, 2) of (u, v), the texture itself in the middle.
void draw_wrap_modes(Run& run) {
  const Texture texture(letter(), MipLevels::none);
  const Size size = run.size({240, 240});
  for (const NamedWrap& mode : wrap_modes()) {
    Image<Rgb8> image(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const float across = (static_cast<float>(x) + 0.5F) / static_cast<float>(size.width);
        const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(size.height);
        const Footprint<float> footprint = {{3 * across - 1, 2 - 3 * down}, {0, 0}, {0, 0}};
        image(x, y) = to_rgb8(sample_nearest(texture, mode.wrap, footprint));
      }
    }
    run.picture("06.1_" + mode.name, image);
  }
}

// 06.2
void draw_planet(Run& run) {
  const Mesh sphere = make_shape("uv_sphere", 64);
  const Texture texture(read_image<Rgb8>(data_path("planet_color.png")));
  Frame frame = frame_of(run, {480, 480});
  draw_textured_mesh(
      {.mesh = sphere,
       .transforms = {.view = look_at({0, 1.2F, 3}, {0, 0, 0}, {0, 1, 0}),
                      .projection = perspective(40, aspect_of(frame), 0.1F, 20)},
       .light = {.position = {-1, 1, 1, 0}},
       .material = {.ambient = 0.1F, .diffuse = 1, .specular = 0.3F, .shininess = 20},
       .cull = Cull::back},
      {.texture = &texture, .filter = Filter::trilinear}, frame);
  run.picture("06.2_planet", frame.color);
}

// 06.3: course C's wall, seen along.
void draw_perspective_ladder(Run& run) {
  const Mesh wall = read_mesh(data_path("wall.off"));
  const Texture texture(read_image<Rgb8>(data_path("brick.png")), MipLevels::none);
  Frame frame = frame_of(run, {480, 360});
  const Transforms transforms = {.view = look_at({-4.6F, 0.3F, 2.6F}, {-1.6F, 0, 0}, {0, 1, 0}),
                                 .projection = perspective(45, aspect_of(frame), 0.1F, 20)};
  const Eigen::Matrix4f matrix = transforms.to_clip();
  for (const NamedPerspectiveRung& rung : perspective_ladder()) {
    if (!run.draws(rung.name)) continue;
    clear(frame);
    for (const auto& [a, b, c] : wall.triangles) {
      draw_textured_triangle(
          {to_clip(matrix, wall.positions[a]), to_clip(matrix, wall.positions[b]),
           to_clip(matrix, wall.positions[c])},
          {wall.texture_coordinates[a], wall.texture_coordinates[b], wall.texture_coordinates[c]},
          {.texture = &texture, .filter = Filter::bilinear}, rung.weights, frame);
    }
    run.picture("06.3_" + rung.name, frame.color);
  }
}

namespace {

/// A level floor to the horizon, a picture of `size` with nothing but the texture on it.
Image<Rgb8> draw_floor(const Sampler& sampler, Size size) {
  Mesh floor = make_shape("grid", 1);
  for (Eigen::Vector2f& uv : floor.texture_coordinates) uv *= 200;
  Frame frame = make_frame(size.width, size.height);
  const Transforms transforms = {.model = scaling(Eigen::Vector3f::Constant(200)),
                                 .view = look_at({0, 1, 0}, {0.3F, 0.8F, -1}, {0, 1, 0}),
                                 .projection = perspective(50, aspect_of(frame), 0.1F, 1000)};
  draw_textured_mesh({.mesh = floor,
                      .transforms = transforms,
                      .light = {},
                      .material = {.ambient = 1, .diffuse = 0, .specular = 0}},
                     sampler, frame);
  return frame.color;
}

/// Each pixel the mean of factor × factor.
Image<Rgb8> averaged(const Image<Rgb8>& image, int factor) {
  Image<Rgb8> result(image.width() / factor, image.height() / factor);
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      Color sum = Color::Zero();
      for (int j = 0; j < factor; ++j) {
        const Rgb8* row = image.row(y * factor + j) + static_cast<std::ptrdiff_t>(x) * factor;
        for (int i = 0; i < factor; ++i) sum += to_color(row[i]);
      }
      result(x, y) = to_rgb8(sum / static_cast<float>(factor * factor));
    }
  }
  return result;
}

double root_mean_square_difference(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    sum += (to_color(a.pixels()[i]) - to_color(b.pixels()[i])).squaredNorm();
  }
  return 255 * std::sqrt(sum / (3 * static_cast<double>(a.pixels().size())));
}

}  // namespace

// 06.4: the same floor with every filter, and with 64 samples a pixel, which is what they are to
// come near to.
void draw_filter_ladder(Run& run) {
  const Texture texture(read_image<Rgb8>(data_path("checker.png")));
  const Size size = run.size({480, 320});
  constexpr int factor = 8;
  const Image<Rgb8> reference =
      averaged(draw_floor({.texture = &texture, .filter = Filter::nearest},
                          {size.width * factor, size.height * factor}),
               factor);
  std::string text = "root mean square difference from 64 samples a pixel, in code values\n";
  for (const FilterRung& rung : filter_ladder()) {
    if (!run.draws(rung.name)) continue;
    const Image<Rgb8> image = draw_floor({.texture = &texture, .filter = rung.filter}, size);
    run.picture("06.4_" + rung.name, image);
    std::array<char, 80> line{};
    std::snprintf(line.data(), line.size(), "%-12s %6.2f\n", rung.name.c_str(),
                  root_mean_square_difference(image, reference));
    text += line.data();
  }
  if (run.settings().algorithm.empty()) run.picture("06.4_64_samples", reference);
  run.printout("06.4_differences", text);
}

}  // namespace rasterlab

#include "data/textures.h"

#include "data/noise.h"
#include "data/planet.h"

#include <cmath>
#include <numbers>

namespace rasterlab {
namespace {

// 8 × 8 fields, each with a border to see texels by.
Image<Rgb8> checker() {
  constexpr int field = 8;
  Image<Rgb8> image(8 * field, 8 * field);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const bool light = (x / field + y / field) % 2 == 0;
      image(x, y) = light ? Rgb8{236, 231, 218} : Rgb8{52, 73, 110};
    }
  }
  return image;
}

// Rows of bricks, every other moved by half a brick; repeats without a seam.
Image<Rgb8> brick() {
  constexpr int size = 128;
  constexpr int brick_width = 32;
  constexpr int brick_height = 16;
  constexpr int mortar = 2;
  Image<Rgb8> image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const int row = y / brick_height;
      const int moved = (x + row % 2 * brick_width / 2) % size;
      const bool in_mortar = moved % brick_width < mortar || y % brick_height < mortar;
      const double grain = lattice_value(x, y, 0, 1) - 0.5;
      const double shade = lattice_value(moved / brick_width, row, 0, 2) - 0.5;
      const Color color = in_mortar ? Color(0.74F, 0.71F, 0.66F) : Color(0.62F, 0.26F, 0.18F);
      const double factor = 1 + 0.10 * grain + (in_mortar ? 0 : 0.35 * shade);
      image(x, y) = to_rgb8(static_cast<float>(factor) * color);
    }
  }
  return image;
}

// East, north and up where the UV sphere (common/mesh/shapes.h) has texture coordinates (u, v).
Eigen::Matrix3d frame_on_sphere(double u, double v) {
  const double longitude = 2 * std::numbers::pi * (u - 0.5);
  const double latitude = std::numbers::pi * (v - 0.5);
  Eigen::Matrix3d frame;
  frame.col(0) << std::cos(longitude), 0, -std::sin(longitude);
  frame.col(2) << std::cos(latitude) * std::sin(longitude), std::sin(latitude),
      std::cos(latitude) * std::cos(longitude);
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// A map of the planet, each texel by what `value` makes of the frame at its centre.
template <class Pixel, class Value>
Image<Pixel> planet_map(Value value) {
  Image<Pixel> image(512, 256);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) =
          value(frame_on_sphere((x + 0.5) / image.width(), 1 - (y + 0.5) / image.height()));
    }
  }
  return image;
}

// A unit vector as a colour: (n + 1) / 2.
Rgb8 normal_to_rgb8(const Eigen::Vector3d& normal) {
  return to_rgb8(((normal + Eigen::Vector3d::Ones()) / 2).cast<float>());
}

}  // namespace

std::vector<MadeTexture> make_textures() {
  using Frame = Eigen::Matrix3d;
  return {
      {"brick.png", brick()},
      {"checker.png", checker()},
      {"planet_color.png",
       planet_map<Rgb8>([](const Frame& frame) { return to_rgb8(ground_color(frame.col(2))); })},
      {"planet_specular.png", planet_map<std::uint8_t>([](const Frame& frame) {
         return is_sea(frame.col(2)) ? std::uint8_t{230} : std::uint8_t{25};
       })},
      {"planet_normal_object.png", planet_map<Rgb8>([](const Frame& frame) {
         return normal_to_rgb8(ground_normal(frame.col(2)));
       })},
      {"planet_normal_tangent.png", planet_map<Rgb8>([](const Frame& frame) {
         return normal_to_rgb8(frame.transpose() * ground_normal(frame.col(2)));
       })},
  };
}

}  // namespace rasterlab

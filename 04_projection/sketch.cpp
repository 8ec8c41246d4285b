#include "04_projection/sketch.h"

#include "common/lines/draw_line.h"
#include "common/projection/transforms_2d.h"

#include <array>
#include <cmath>

namespace rasterlab {
namespace {

constexpr Rgb8 axis_color{90, 90, 90};

const std::array<Eigen::Vector2f, 10> letter_f = {{{0, 0},
                                                   {0.3F, 0},
                                                   {0.3F, 0.5F},
                                                   {0.7F, 0.5F},
                                                   {0.7F, 0.75F},
                                                   {0.3F, 0.75F},
                                                   {0.3F, 1},
                                                   {0.9F, 1},
                                                   {0.9F, 1.25F},
                                                   {0, 1.25F}}};

}  // namespace

Sketch::Sketch(int size, float extent) : extent_(extent), image_(size, size) {
  segment({-extent, 0}, {extent, 0}, axis_color);
  segment({0, -extent}, {0, extent}, axis_color);
}

Eigen::Vector2i Sketch::pixel(const Eigen::Vector2f& point) const {
  const float half = static_cast<float>(image_.width()) / 2;
  const Eigen::Vector2f window((point.x() / extent_ + 1) * half, (1 - point.y() / extent_) * half);
  return window.array().floor().cast<int>();
}

void Sketch::segment(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Rgb8& color) {
  draw_line(image_, pixel(a), pixel(b), color);
}

void Sketch::dot(const Eigen::Vector2f& point, const Rgb8& color) {
  const Eigen::Vector2i center = pixel(point);
  for (int row = -1; row <= 1; ++row) {
    draw_line(image_, center + Eigen::Vector2i(-1, row), center + Eigen::Vector2i(1, row), color);
  }
}

void Sketch::letter(const Eigen::Matrix3f& transform, const Rgb8& color) {
  for (std::size_t i = 0; i < letter_f.size(); ++i) {
    const Eigen::Vector2f& a = letter_f[i];
    const Eigen::Vector2f& b = letter_f[(i + 1) % letter_f.size()];
    segment(to_plane(transform * point_2d(a.x(), a.y())),
            to_plane(transform * point_2d(b.x(), b.y())), color);
  }
}

}  // namespace rasterlab

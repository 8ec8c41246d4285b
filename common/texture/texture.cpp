#include "common/texture/texture.h"

#include "common/image/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlab {
namespace {

Image<Color> to_colors(const Image<Rgb8>& image) {
  Image<Color> colors(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), colors.pixels().begin(), to_color);
  return colors;
}

/// The mean of `pixel(i)` over begin ≤ i < end, whose ends may lie within a pixel.
template <class Pixel>
Color mean(double begin, double end, int count, Pixel pixel) {
  Color sum = Color::Zero();
  const int last = std::min(static_cast<int>(std::ceil(end)), count);
  for (int i = static_cast<int>(begin); i < last; ++i) {
    const double part = std::min<double>(end, i + 1) - std::max<double>(begin, i);
    sum += pixel(i) * static_cast<float>(part / (end - begin));
  }
  return sum;
}

Image<Color> halved_in_x(const Image<Color>& image) {
  Image<Color> result(std::max(image.width() / 2, 1), image.height(), Color::Zero());
  const double scale = static_cast<double>(image.width()) / result.width();
  for (int y = 0; y < result.height(); ++y) {
    const Color* row = image.row(y);
    for (int x = 0; x < result.width(); ++x) {
      result.row(y)[x] =
          mean(x * scale, (x + 1) * scale, image.width(), [row](int i) { return row[i]; });
    }
  }
  return result;
}

Image<Color> halved_in_y(const Image<Color>& image) {
  Image<Color> result(image.width(), std::max(image.height() / 2, 1), Color::Zero());
  const double scale = static_cast<double>(image.height()) / result.height();
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      result.row(y)[x] = mean(y * scale, (y + 1) * scale, image.height(),
                              [&image, x](int i) { return image.row(i)[x]; });
    }
  }
  return result;
}

}  // namespace

Image<Color> halved(const Image<Color>& image) {
  return halved_in_y(halved_in_x(image));
}

Texture::Texture(const Image<Rgb8>& image, MipLevels levels) {
  if (image.empty()) throw CheckError("a texture needs at least one texel");
  Image<Color> level = to_colors(image);
  append_level(level);
  if (levels == MipLevels::none) return;
  while (level_count_ < max_levels && std::max(level.width(), level.height()) > 1) {
    level = halved(level);
    append_level(level);
  }
}

void Texture::append_level(const Image<Color>& image) {
  const auto index = static_cast<std::size_t>(level_count_++);
  const std::size_t block = (texels_.size() + texels_per_block - 1) / texels_per_block;
  widths_[index] = static_cast<float>(image.width());
  heights_[index] = static_cast<float>(image.height());
  blocks_[index] = static_cast<float>(block);
  texels_.resize(block * texels_per_block);
  texels_.reserve(texels_.size() + image.pixels().size());
  for (int y = image.height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb8 pixel = to_rgb8(image.row(y)[x]);
      texels_.push_back(pack_texel(pixel.r, pixel.g, pixel.b));
    }
  }
}

}  // namespace rasterlab

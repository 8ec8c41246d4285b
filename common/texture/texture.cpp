#include "common/texture/texture.h"

#include "common/image/check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace rasterlab {
namespace {

/// As codes, whose means floats hold exactly down to the 1 × 1 level of a picture of 256 × 256.
Image<Color> to_codes(const Image<Rgb8>& image) {
  Image<Color> codes(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), codes.pixels().begin(),
                 [](const Rgb8& pixel) { return Color(pixel.r, pixel.g, pixel.b); });
  return codes;
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
  Image<Color> level = to_codes(image);
  append_level(level);
  if (levels == MipLevels::none) return;
  while (level_count_ < max_levels && std::max(level.width(), level.height()) > 1) {
    level = halved(level);
    append_level(level);
  }
}

int Texture::levels_left_out() const {
  const auto longest_side = static_cast<unsigned>(std::max(width(), height()));
  return std::min(static_cast<int>(std::bit_width(longest_side)), max_levels) - level_count_;
}

void Texture::append_level(const Image<Color>& codes) {
  const auto index = static_cast<std::size_t>(level_count_++);
  const std::size_t block = (texels_.size() + texels_per_block - 1) / texels_per_block;
  widths_[index] = static_cast<float>(codes.width());
  heights_[index] = static_cast<float>(codes.height());
  blocks_[index] = static_cast<float>(block);
  texels_.resize(block * texels_per_block);
  texels_.reserve(texels_.size() + codes.pixels().size());
  const auto texel = [](const Color& code) {
    const auto rounded = (code.array() + 0.5F).cast<std::uint8_t>().eval();
    return pack_texel(rounded[0], rounded[1], rounded[2]);
  };
  for (int y = codes.height() - 1; y >= 0; --y) {
    for (int x = 0; x < codes.width(); ++x) {
      texels_.push_back({texel(codes.row(y)[x]), texel(codes.row(std::max(y - 1, 0))[x])});
    }
  }
}

}  // namespace rasterlab

#include "common/engine/framebuffer.h"

#include "common/engine/frame_access.h"
#include "common/image/check.h"

#include <algorithm>
#include <array>
#include <limits>

namespace rasterlab {

namespace {

int checked_tile_size(int tile_size) {
  if (tile_size != 16 && tile_size != 32 && tile_size != 64) {
    throw CheckError("a tile has 16, 32 or 64 pixels a side, not " + std::to_string(tile_size));
  }
  return tile_size;
}

}  // namespace

Framebuffer::Framebuffer(int width, int height, int tile_size)
    : width_(width),
      height_(height),
      tile_size_(checked_tile_size(tile_size)),
      tiles_x_((width + tile_size - 1) / tile_size),
      tiles_y_((height + tile_size - 1) / tile_size),
      color_(width, height) {
  const auto tiles = static_cast<std::size_t>(tile_count());
  const std::size_t pixels = tiles * static_cast<std::size_t>(tile_pixels());
  drawn_.assign(tiles, FrameAccess::not_drawn);
  has_color_.assign(tiles, FrameAccess::background);
  // Not written before a tile is drawn into: memory that is never touched is never there.
  tile_far_ = std::make_unique<float[]>(tiles);
  depth_ = HugePages<float>(pixels);
  key_ = HugePages<std::uint32_t>(pixels);
  // As many more as the widest vector that begins at the last tile's reads.
  block_far_ = std::make_unique<float[]>(pixels / 64 + 16);
}

void Framebuffer::clear(const Rgb8& background) {
  const bool keeps = background == background_there_;
  for (std::uint8_t& state : has_color_) {
    if (state == FrameAccess::picture || !keeps) state = FrameAccess::stale;
  }
  const std::size_t blocks = static_cast<std::size_t>(tile_pixels()) / 64;
  for (std::size_t tile = 0; tile < drawn_.size(); ++tile) {
    if (drawn_[tile] == FrameAccess::drawn_here) {
      std::fill_n(block_far_.get() + tile * blocks, blocks, 0.0F);
    }
  }
  std::fill(drawn_.begin(), drawn_.end(), FrameAccess::not_drawn);
  std::fill_n(tile_far_.get(), drawn_.size(), 0.0F);
  background_ = background_there_ = background;
  keys_used_ = 0;
  kept_ = Keep::everything;
}

void Framebuffer::fill_background(int tile) const {
  const int left = tile % tiles_x_ * tile_size_;
  const int top = tile / tiles_x_ * tile_size_;
  const int columns = std::min(tile_size_, width_ - left);
  // Copied whole: a compiler writes pixels of three bytes one by one.
  std::array<Rgb8, 64> row;
  std::fill_n(row.begin(), columns, background_);
  for (int y = top; y < std::min(top + tile_size_, height_); ++y) {
    std::copy_n(row.begin(), columns, color_.row(y) + left);
  }
  has_color_[static_cast<std::size_t>(tile)] = FrameAccess::background;
}

const Image<Rgb8>& Framebuffer::color() const {
  for (int tile = 0; tile < tile_count(); ++tile) {
    if (has_color_[static_cast<std::size_t>(tile)] == FrameAccess::stale) fill_background(tile);
  }
  return color_;
}

template <class Value, class Pixel>
Image<Pixel> Framebuffer::read(const Value* values, Pixel empty) const {
  Image<Pixel> image(width_, height_, empty);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const int tile = y / tile_size_ * tiles_x_ + x / tile_size_;
      if (drawn_[static_cast<std::size_t>(tile)] == FrameAccess::not_drawn) continue;
      const int x_in_tile = x % tile_size_;
      const int y_in_tile = y % tile_size_;
      const int block = y_in_tile / 8 * (tile_size_ / 8) + x_in_tile / 8;
      const int pixel = block * 64 + y_in_tile % 8 * 8 + x_in_tile % 8;
      image.row(y)[x] =
          static_cast<Pixel>(values[static_cast<std::ptrdiff_t>(tile) * tile_pixels() + pixel]);
    }
  }
  return image;
}

void Framebuffer::expect_ids() const {
  if (kept_ != Keep::everything) {
    throw CheckError("the last draw call did not keep which triangle each pixel shows");
  }
}

Image<std::int32_t> Framebuffer::ids() const {
  expect_ids();
  Image<std::int32_t> image = read<std::uint32_t, std::int32_t>(key_.get(), 0);
  for (std::int32_t& id : image.pixels()) --id;
  return image;
}

Image<float> Framebuffer::depth() const {
  if (kept_ == Keep::color) throw CheckError("the last draw call did not keep depth");
  return read<float, float>(depth_.get(), 0.0F);
}

Image<float> Framebuffer::distance(const Eigen::Matrix4f& projection) const {
  expect_ids();
  // Along the view axis, z of the camera's frame: w = γz + δ and depth · w = αz + β.
  const Eigen::Matrix4d p = projection.cast<double>();
  const double alpha = (p(3, 2) - p(2, 2)) / 2;
  const double beta = (p(3, 3) - p(2, 3)) / 2;
  const Image<std::uint32_t> keys = read<std::uint32_t, std::uint32_t>(key_.get(), 0);
  Image<float> image = depth();
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const double d = image.pixels()[i];
    const double z = (beta - d * p(3, 3)) / (d * p(3, 2) - alpha);
    image.pixels()[i] =
        keys.pixels()[i] == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(-z);
  }
  return image;
}

}  // namespace rasterlab

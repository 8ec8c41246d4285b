// What the engine draws into.
#pragma once

#include "common/image/huge_pages.h"
#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>
#include <memory>

#include <Eigen/Dense>

namespace rasterlab {

/// What of a framebuffer is still wanted after a draw call. What isn't need not reach memory: a
/// tile at work then stays in the cache of the core that draws it.
enum class Keep : std::uint8_t {
  everything,  ///< more may be drawn into it
  depth,       ///< the picture and its depth
  color,       ///< the picture
};

/// A picture in the making: colour, depth and which triangle is seen, kept tile by tile. clear()
/// costs nothing by itself: a tile is wiped when something is first drawn into it.
class Framebuffer {
 public:
  /// `tile_size` is 16, 32 or 64 pixels and changes no pixel. Throws CheckError when a side is
  /// negative or there are too many pixels, or for another tile size.
  Framebuffer(int width, int height, int tile_size = 64);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Nothing drawn yet; everywhere `background`.
  void clear(const Rgb8& background = {});

  /// The picture.
  const Image<Rgb8>& color() const;

  // All of these throw CheckError when the last draw call did not keep what they give.

  /// Per pixel, the number of the triangle that is seen: its index in its mesh, plus the triangles
  /// of all meshes drawn before since clear(); −1 where nothing was drawn. For Keep::everything.
  Image<std::int32_t> ids() const;

  /// Per pixel, reversed depth: (1 − z/w)/2 of clip space, from 1 on the near plane down to 0 far
  /// away, 0 where nothing was drawn. Not for Keep::color.
  Image<float> depth() const;

  /// Per pixel, the distance along the view axis, +∞ where nothing was drawn. `projection` is the
  /// matrix from the camera's frame to clip space with which everything was drawn. For
  /// Keep::everything.
  Image<float> distance(const Eigen::Matrix4f& projection) const;

 private:
  friend class FrameAccess;

  template <class Value, class Pixel>
  Image<Pixel> read(const Value* values, Pixel empty) const;
  int tile_count() const { return tiles_x_ * tiles_y_; }
  int tile_pixels() const { return tile_size_ * tile_size_; }
  void fill_background(int tile) const;
  void expect_ids() const;

  int width_;
  int height_;
  int tile_size_;
  int tiles_x_;
  int tiles_y_;
  Rgb8 background_;
  std::uint32_t keys_used_ = 0;  ///< triangles of the draw calls since clear()
  Keep kept_ = Keep::everything;

  // Per tile.
  std::vector<std::uint8_t> drawn_;              ///< whether something is, and where its depth is
  mutable std::vector<std::uint8_t> has_color_;  ///< nothing, the background, or a picture
  Rgb8 background_there_;                        ///< which background those have
  std::unique_ptr<float[]> tile_far_;            ///< the farthest depth in the tile

  // Tile after tile, in a tile 8×8 blocks row by row, in a block pixels row by row.
  HugePages<float> depth_;
  HugePages<std::uint32_t> key_;        ///< id + 1; 0: nothing
  std::unique_ptr<float[]> block_far_;  ///< per block, the farthest depth in it; 0 if it isn't here
  mutable Image<Rgb8> color_;
};

}  // namespace rasterlab

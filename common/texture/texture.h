// A picture laid on a surface, with its smaller copies.
#pragma once

#include "common/image/huge_pages.h"
#include "common/image/image.h"
#include "common/image/number.h"
#include "common/image/pixel.h"
#include "common/texture/wrap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlab {

/// What near_squares() finds for a Number that has no way of its own.
struct NoNearSquares {
  static constexpr bool found = false;
};
/// Where squares of four texels are, their first ones in columns `left` and rows `low` of a picture
/// (whole numbers, or not numbers): `found` if the lanes' are so close together, and to no edge,
/// that it is quicker to have them all at once.
template <class Number>
auto near_squares(int width, int height, const Number& left, const Number& low) {
  if constexpr (requires { find_near_squares(width, height, left, low); }) {
    return find_near_squares(width, height, left, low);
  } else {
    return NoNearSquares();
  }
}

/// Whether a texture also holds its smaller copies, which only some filters read.
enum class MipLevels { none, all };

/// A picture over the unit square of (u, v), v up: (0, 0) is its lower left corner, (1, 1) its
/// upper right one. Level 0 is the picture; each further level has half the sides, rounded down, to
/// 1 × 1, each texel the mean of the area it stands for, rounded to 8 bit, halves up. (The mean of
/// the picture's texels: no level is made of rounded ones.) Sixteen levels at the most.
///
/// Texels are packed in 32 bits, all levels in one array, each level's rows from the bottom up:
/// what a SIMD gather can read. Each is followed by the one above it (above the top row, by
/// itself), so that the four about a point are 16 bytes: of what a blend of four costs, finding and
/// fetching them is most. Computed on any Number (common/image/number.h).
class Texture {
 public:
  static constexpr int max_levels = 16;

  /// Throws CheckError when the image is empty.
  explicit Texture(const Image<Rgb8>& image, MipLevels levels = MipLevels::all);

  int width() const { return static_cast<int>(widths_[0]); }
  int height() const { return static_cast<int>(heights_[0]); }
  int level_count() const { return level_count_; }
  /// How many more there would be with MipLevels::all.
  int levels_left_out() const;

  /// One level, or one per lane.
  template <class Number>
  struct Level {
    Number width;   ///< in texels
    Number height;  ///< in texels
    Whole<Number> stride;
    Whole<Number> first;
  };

  /// `index` is a whole number from 0 to level_count() − 1.
  template <class Number>
  Level<Number> level(const Number& index) const {
    const Number width = gather(widths_, index);
    return {width, gather(heights_, index), to_whole(width),
            to_whole(gather(blocks_, index)) * to_whole(Number(texels_per_block))};
  }

  /// A texel of a level: red, green, blue from 0 to 255. `column` from the left and `row` from the
  /// bottom are whole numbers, 0 ≤ column < width and 0 ≤ row < height.
  template <class Number>
  Vector3<Number> texel(const Level<Number>& level, const Number& column, const Number& row) const {
    return gather_texel(texels_.data(), place(level, column, row));
  }

  // Where four texels lie that are next to each other: the same in all textures of one size. One of
  // three kinds.

  /// Of level 0, lanes close together.
  template <class Number>
  using NearSquare = decltype(near_squares(0, 0, Number(), Number()));
  /// Side by side in all lanes: the place of the first one.
  template <class Number>
  struct WholeSquare {
    Whole<Number> first;
  };
  /// The place of each.
  template <class Number>
  struct AnySquare {
    std::array<Whole<Number>, 4> place;
  };

  /// Calls `visit` with the place of the square of row `low`, in column `left` and the next one,
  /// then of the next row. Both from −1 up, and with what is next may be one beyond the edge, where
  /// `wrap` says what is.
  template <class Number, class Visit>
  auto place_square(const Level<Number>& level, const Number& left, const Number& low, Wrap wrap,
                    const Visit& visit) const {
    const auto has_next = [](const Number& first, const Number& size) {
      return first >= Number(0) && first < size - Number(1);
    };
    if constexpr (requires { gather_square(texels_.data(), level.first); }) {
      if (all(has_next(left, level.width) && has_next(low, level.height))) {
        return visit(WholeSquare<Number>{place(level, left, low)});
      }
    }
    const std::array<Number, 2> column = {
        wrap_neighbor(left, level.width, wrap),
        wrap_neighbor(Number(left + Number(1)), level.width, wrap)};
    const std::array<Number, 2> row = {wrap_neighbor(low, level.height, wrap),
                                       wrap_neighbor(Number(low + Number(1)), level.height, wrap)};
    return visit(
        AnySquare<Number>{{place(level, column[0], row[0]), place(level, column[1], row[0]),
                           place(level, column[0], row[1]), place(level, column[1], row[1])}});
  }

  /// In level 0.
  template <class Number>
  NearSquare<Number> near_square(const Number& left, const Number& low) const {
    return near_squares(width(), height(), left, low);
  }

  /// The four texels of a square: red, green, blue from 0 to 255.
  template <class Near>
  auto texels(const Near& square) const {
    return gather_near_squares(texels_.data(), width(), square);
  }
  template <class Number>
  std::array<Vector3<Number>, 4> texels(const WholeSquare<Number>& square) const {
    return gather_square(texels_.data(), square.first);
  }
  template <class Number>
  std::array<Vector3<Number>, 4> texels(const AnySquare<Number>& square) const {
    const auto texel = [&](std::size_t i) { return gather_texel(texels_.data(), square.place[i]); };
    return {texel(0), texel(1), texel(2), texel(3)};
  }

 private:
  template <class Number>
  Whole<Number> place(const Level<Number>& level, const Number& column, const Number& row) const {
    return level.first + to_whole(row) * level.stride + to_whole(column);
  }

  void append_level(const Image<Color>& codes);

  static constexpr int texels_per_block = 64;

  // Sizes and places are kept as floats, for gather(); a place is counted in blocks, so that it
  // stays exact.
  std::array<float, max_levels> widths_{};
  std::array<float, max_levels> heights_{};
  std::array<float, max_levels> blocks_{};
  int level_count_ = 0;
  std::vector<TexelAndAbove, HugePageAllocator<TexelAndAbove>> texels_;
};

/// The image at half the sides, rounded down but at least 1: each pixel the mean of the area it
/// stands for, pixels that area cuts through counted by the part inside.
Image<Color> halved(const Image<Color>& image);

}  // namespace rasterlab

// The way from object space to the window, the same for every instruction set.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include <Eigen/Dense>

namespace rasterlab {

/// The rows of a draw call's matrix, and the picture's size. Depth is its own row, (w − z)/2 of
/// clip space, which for an infinite far plane is exactly constant; in double, because near a
/// finite far plane w − z cancels.
struct ClipTransform {
  std::array<std::array<float, 4>, 4> row;
  std::array<double, 4> depth_row;
  float half_width;
  float half_height;
  /// How far |x/w| and |y/w| may go without clipping; as exercise 04.9 has it, so that both cut the
  /// same triangles in the same places.
  float guard_x;
  float guard_y;

  ClipTransform(const Eigen::Matrix4f& matrix, int picture_width, int picture_height)
      : half_width(static_cast<float>(picture_width) / 2),
        half_height(static_cast<float>(picture_height) / 2),
        guard_x(guard_band(picture_width)),
        guard_y(guard_band(picture_height)) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      for (std::size_t r = 0; r < 4; ++r) row[r][i] = matrix(static_cast<Eigen::Index>(r), column);
      depth_row[i] = (static_cast<double>(matrix(3, column)) - matrix(2, column)) / 2;
    }
  }

  static float guard_band(int side) {
    return static_cast<float>(std::bit_floor(32768U / static_cast<unsigned>(std::max(side, 1))));
  }
};

/// Coordinates of this magnitude, in 1/256 pixel, are drawn as they are; what reaches further is
/// clipped. So edge functions stay below 2^50 and are exact in doubles too.
inline constexpr int max_window_coordinate = 32768 * 256;

}  // namespace rasterlab

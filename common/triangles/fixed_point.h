// Where a vertex really is: on a grid of 1/256 pixel, in integers, so that whether a triangle
// covers a pixel is never a matter of rounding.
#pragma once

#include "common/image/check.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <Eigen/Dense>

namespace rasterlab {

__extension__ using Int128 = __int128;

/// Units of a snapped coordinate per pixel.
inline constexpr std::int64_t subpixels = 256;

/// Coordinates of this magnitude, in pixels, are exact in 64-bit edge functions; what reaches
/// further must be clipped first, or be drawn by what works in 128 bits.
inline constexpr double max_coordinate = 32768;

/// What 128-bit edge functions are used to.
inline constexpr double max_wide_coordinate = 1 << 30;

/// The corners of a triangle in pixels: window coordinates, y down, pixel (x, y) having its centre
/// at (x + ½, y + ½).
using Corners = std::array<Eigen::Vector2d, 3>;

/// The same in units of 1/256 pixel; centres are at (256 x + 128, 256 y + 128).
using SnappedPoint = Eigen::Matrix<std::int64_t, 2, 1>;
using SnappedTriangle = std::array<SnappedPoint, 3>;

/// 256 · pixels to the nearest integer, ties to even. For |pixels| ≤ 2^40.
inline std::int64_t snap(double pixels) {
  // In [2^52, 2^53) a double's last bit is worth 1: adding 1.5 · 2^52 rounds, and leaves the
  // integer in the low bits.
  constexpr double rounder = 0x1.8p52;
  return std::bit_cast<std::int64_t>(pixels * static_cast<double>(subpixels) + rounder) -
         std::bit_cast<std::int64_t>(rounder);
}

/// Whether no coordinate is beyond ±limit; one that is not a number is.
template <class Scalar>
bool within(const std::array<Eigen::Matrix<Scalar, 2, 1>, 3>& corners, double limit) {
  bool inside = true;
  for (const auto& corner : corners) {
    inside &= std::fabs(corner.x()) <= limit && std::fabs(corner.y()) <= limit;
  }
  return inside;
}

[[noreturn]] inline void throw_beyond(double limit) {
  throw CheckError("a triangle's corner is beyond " + std::to_string(static_cast<int>(limit)) +
                   " pixels");
}

/// Corners in pixels to the grid; for coordinates within ±2^40.
template <class Scalar>
SnappedTriangle snap_unchecked(const std::array<Eigen::Matrix<Scalar, 2, 1>, 3>& corners) {
  SnappedTriangle snapped;
  for (std::size_t i = 0; i < 3; ++i) snapped[i] = {snap(corners[i].x()), snap(corners[i].y())};
  return snapped;
}

/// The same. Throws CheckError when a coordinate is beyond ±limit or not a number.
template <class Scalar>
SnappedTriangle snap(const std::array<Eigen::Matrix<Scalar, 2, 1>, 3>& corners,
                     double limit = max_coordinate) {
  if (!within(corners, limit)) throw_beyond(limit);
  return snap_unchecked(corners);
}

}  // namespace rasterlab

// Where a vertex really is: on a grid of 1/256 pixel, in integers, so that whether a triangle
// covers a pixel is never a matter of rounding.
#pragma once

#include "common/image/check.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// Units of a snapped coordinate per pixel.
inline constexpr std::int64_t subpixels = 256;

/// Coordinates of this magnitude, in pixels, are exact in 64-bit edge functions; what reaches
/// further must be clipped first.
inline constexpr double max_coordinate = 32768;

/// The corners of a triangle in units of 1/256 pixel, x right and y down; pixel (x, y) has its
/// centre at (256 x + 128, 256 y + 128).
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

/// Corners in pixels to the grid. Throws CheckError when a coordinate is beyond ±32768 or not a
/// number.
template <class Scalar>
SnappedTriangle snap(const std::array<Eigen::Matrix<Scalar, 2, 1>, 3>& corners) {
  SnappedTriangle snapped;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = corners[i].x();
    const double y = corners[i].y();
    if (!(std::fabs(x) <= max_coordinate && std::fabs(y) <= max_coordinate)) {
      throw CheckError("a triangle's corner is beyond 32768 pixels: clip it first");
    }
    snapped[i] = {snap(x), snap(y)};
  }
  return snapped;
}

}  // namespace rasterlab

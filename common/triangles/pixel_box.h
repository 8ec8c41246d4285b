// Where a triangle may cover pixels.
#pragma once

#include "common/triangles/fixed_point.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

/// Columns left … right and rows top … bottom, all included; none where an upper bound is below its
/// lower one.
struct PixelBox {
  int left;
  int top;
  int right;
  int bottom;
};

/// The pixels inside a width × height image that the box around the corners touches.
inline PixelBox pixel_box(const Corners& corners, int width, int height) {
  const auto pixel = [](double coordinate, int low, int high) {
    return static_cast<int>(std::clamp<double>(std::floor(coordinate), low, high));
  };
  const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  return {pixel(left, 0, width), pixel(top, 0, height), pixel(right, -1, width - 1),
          pixel(bottom, -1, height - 1)};
}

}  // namespace rasterlab

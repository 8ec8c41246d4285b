// How often each pixel is covered.
#pragma once

#include "common/image/image.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fixed_point.h"
#include "common/triangles/pixel_box.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace rasterlab {

/// Pixel counts, at most 65535 each.
using Coverage = Image<std::uint16_t>;

/// Calls `visit(x, y)` for every pixel that `fill` draws of a triangle. `scratch` is black before
/// and after; `fill` must draw within a pixel of the box around the corners.
template <class Visit>
void for_each_drawn_pixel(FillTriangle fill, const Corners& corners, Image<Rgb8>& scratch,
                          Visit&& visit) {
  fill(scratch, corners, Rgb8{255, 255, 255});
  const PixelBox box = pixel_box(corners, scratch.width(), scratch.height());
  for (int y = std::max(box.top - 1, 0); y <= std::min(box.bottom + 1, scratch.height() - 1); ++y) {
    for (int x = std::max(box.left - 1, 0); x <= std::min(box.right + 1, scratch.width() - 1);
         ++x) {
      if (scratch(x, y) == Rgb8{}) continue;
      scratch(x, y) = Rgb8{};
      visit(x, y);
    }
  }
}

inline void count_up(std::uint16_t& count) {
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
}

/// How many of the triangles `fill` draws in each pixel.
Coverage coverage(FillTriangle fill, const std::vector<Corners>& triangles, int width, int height);

}  // namespace rasterlab

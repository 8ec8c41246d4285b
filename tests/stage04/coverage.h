// How many times pixels are covered.
#pragma once

#include "common/image/image.h"
#include "common/projection/triangle_pixels.h"

#include <vector>

namespace rasterlab {

inline Image<int> coverage(const std::vector<ClipTriangle>& triangles, int width, int height,
                           const TriangleOptions& options = {}) {
  Image<int> count(width, height, 0);
  TriangleCounts counts;
  for (const ClipTriangle& triangle : triangles) {
    for_each_pixel(triangle, width, height, options, counts,
                   [&](const TrianglePixel& pixel) { ++count(pixel.x, pixel.y); });
  }
  return count;
}

inline int total(const Image<int>& count) {
  int sum = 0;
  for (const int pixel : count.pixels()) sum += pixel;
  return sum;
}

}  // namespace rasterlab

#include "common/triangles/coverage.h"

namespace rasterlab {

Coverage coverage(FillTriangle fill, const std::vector<Corners>& triangles, int width, int height) {
  Coverage count(width, height);
  Image<Rgb8> scratch(width, height);
  for (const Corners& corners : triangles) {
    for_each_drawn_pixel(fill, corners, scratch, [&](int x, int y) { count_up(count(x, y)); });
  }
  return count;
}

}  // namespace rasterlab

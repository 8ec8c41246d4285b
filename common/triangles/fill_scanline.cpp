#include "common/triangles/fill_scanline.h"

#include "common/triangles/pixel_corners.h"
#include "common/triangles/triangle_scanline.h"

#include <algorithm>

namespace rasterlab {

void fill_triangle(Image<Rgb8>& image, const std::array<Point, 3>& corners, const Rgb8& color) {
  const std::array<float, 3> no_values = {0, 0, 0};
  for (const auto& row : make_triangle_scanline(corners, no_values, {0, image.height() - 1})) {
    for (int x = std::max(row.left, 0); x <= std::min(row.right, image.width() - 1); ++x)
      image(x, row.y) = color;
  }
}

void fill_scanline(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  fill_triangle(image, pixel_corners(corners), color);
}

}  // namespace rasterlab

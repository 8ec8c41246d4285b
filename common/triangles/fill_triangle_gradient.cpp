#include "common/triangles/fill_triangle_gradient.h"

#include "common/image/check.h"
#include "common/triangles/triangle_scanline.h"

#include <algorithm>

namespace rasterlab {

void fill_triangle_gradient(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                            const std::array<Color, 3>& colors) {
  // <solution>
  for (const auto& row : make_triangle_scanline(corners, colors, {0, image.height() - 1})) {
    const double length = std::max(static_cast<double>(row.right) - row.left, 1.0);
    for (int x = std::max(row.left, 0); x <= std::min(row.right, image.width() - 1); ++x) {
      const auto weight = static_cast<float>((static_cast<double>(x) - row.left) / length);
      image(x, row.y) = to_rgb8((1 - weight) * row.left_value + weight * row.right_value);
    }
  }
  // <starter> throw NotWritten("02.3", image, corners, colors);
  // </solution>
}

}  // namespace rasterlab

// A right answer written differently: from the lowest row up, every pixel asks its row.
#include "common/triangles/fill_triangle_gradient.h"

#include "common/image/check.h"
#include "common/triangles/triangle_scanline.h"

#include <algorithm>

namespace rasterlab {

void fill_triangle_gradient(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                            const std::array<Color, 3>& colors) {
  const auto scanline = make_triangle_scanline(corners, colors, {0, image.height() - 1});
  for (auto row = scanline.rbegin(); row != scanline.rend(); ++row) {
    for (int x = 0; x < image.width(); ++x) {
      if (x < row->left || x > row->right) continue;
      float weight = 0;
      if (row->right > row->left) {
        weight = static_cast<float>((double(x) - row->left) / (double(row->right) - row->left));
      }
      image(x, row->y) = to_rgb8(row->left_value + weight * (row->right_value - row->left_value));
    }
  }
}

}  // namespace rasterlab

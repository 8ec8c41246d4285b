// A right answer written differently: a colour that grows by the same step from pixel to pixel, in
// doubles.
#include "common/triangles/fill_triangle_gradient.h"

#include "common/image/check.h"
#include "common/triangles/triangle_scanline.h"

#include <algorithm>

namespace rasterlab {

void fill_triangle_gradient(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                            const std::array<Color, 3>& colors) {
  for (const auto& row : make_triangle_scanline(corners, colors, {0, image.height() - 1})) {
    const Eigen::Vector3d from = row.left_value.template cast<double>();
    const Eigen::Vector3d to = row.right_value.template cast<double>();
    const double gaps = static_cast<double>(row.right) - row.left;
    const Eigen::Vector3d step =
        gaps > 0 ? Eigen::Vector3d((to - from) / gaps) : Eigen::Vector3d::Zero().eval();
    const int begin = std::max(row.left, 0);
    Eigen::Vector3d color = from + (static_cast<double>(begin) - row.left) * step;
    for (int x = begin; x <= row.right && x < image.width(); ++x, color += step) {
      image(x, row.y) = to_rgb8(color.cast<float>());
    }
  }
}

}  // namespace rasterlab

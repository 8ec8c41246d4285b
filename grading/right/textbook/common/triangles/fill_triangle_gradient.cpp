// A right answer written differently: a colour that a step is added to from pixel to pixel, in
// doubles.
#include "common/triangles/fill_triangle_gradient.h"

#include "common/triangles/triangle_scanline.h"

namespace rasterlab {

void fill_triangle_gradient(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                            const std::array<Color, 3>& colors) {
  const auto scanline = make_triangle_scanline(corners, colors, {0, image.height() - 1});
  for (auto row = scanline.rbegin(); row != scanline.rend(); ++row) {
    const Eigen::Vector3d left = row->left_value.cast<double>();
    const Eigen::Vector3d right = row->right_value.cast<double>();
    const double steps = double(row->right) - row->left;
    const Eigen::Vector3d step = steps > 0 ? Eigen::Vector3d((right - left) / steps)
                                           : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const int first = std::max(row->left, 0);
    Eigen::Vector3d color = left + (double(first) - row->left) * step;
    for (int x = first; x <= row->right && x < image.width(); ++x) {
      image(x, row->y) = to_rgb8(color.cast<float>());
      color += step;
    }
  }
}

}  // namespace rasterlab

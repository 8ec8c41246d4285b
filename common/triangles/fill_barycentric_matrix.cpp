#include "common/triangles/fill_barycentric_matrix.h"

#include "common/triangles/pixel_box.h"

namespace rasterlab {

Eigen::Matrix3f barycentric_matrix(const Corners& corners) {
  Eigen::Matrix3f columns;
  for (int i = 0; i < 3; ++i) {
    columns.col(i) = corners[static_cast<std::size_t>(i)].cast<float>().homogeneous();
  }
  return columns.inverse();
}

void fill_barycentric_matrix(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  if (!within(corners, max_wide_coordinate)) throw_beyond(max_wide_coordinate);
  const Eigen::Matrix3f matrix = barycentric_matrix(corners);
  const PixelBox box = pixel_box(corners, image.width(), image.height());
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      const Eigen::Vector3f weights =
          matrix * Eigen::Vector3f(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, 1);
      if (weights.minCoeff() >= 0) image(x, y) = color;
    }
  }
}

}  // namespace rasterlab

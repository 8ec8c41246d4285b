// A right answer written differently: interpolated by differences from the first corner, tested by
// hand.
#include "common/zbuffer/draw_depth_triangle.h"

#include "common/triangles/rasterize.h"

namespace rasterlab {

void draw_depth_triangle(Image<Rgb8>& image, DepthBuffer& depth,
                         const std::array<DepthCorner, 3>& corners) {
  const DepthCorner &a = corners[0], &b = corners[1], &c = corners[2];
  rasterize_wide_triangle(
      {a.position, b.position, c.position}, image.width(), image.height(),
      [&](int x, int y, const Eigen::Vector3d& w) {
        const auto z = float(a.z + w[1] * (double(b.z) - a.z) + w[2] * (double(c.z) - a.z));
        if (z < -1 || z > 1 || !depth.test(x, y, z)) return;
        depth.write(x, y, z);
        const Eigen::Vector3d mixed = a.color.cast<double>() * w[0] +
                                      b.color.cast<double>() * w[1] + c.color.cast<double>() * w[2];
        image(x, y) = to_rgb8(mixed.cast<float>());
      });
}

}  // namespace rasterlab

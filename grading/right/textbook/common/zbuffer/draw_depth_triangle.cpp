// A right answer written differently: from corner 0 along two sides.
#include "common/zbuffer/draw_depth_triangle.h"

#include "common/image/check.h"
#include "common/triangles/rasterize.h"

namespace rasterlab {

void draw_depth_triangle(Image<Rgb8>& image, DepthBuffer& depth,
                         const std::array<DepthCorner, 3>& corners) {
  const DepthCorner &a = corners[0], &b = corners[1], &c = corners[2];
  const double z_b = double(b.z) - a.z, z_c = double(c.z) - a.z;
  const auto visit = [&](int x, int y, const Eigen::Vector3d& w) {
    const auto to_b = static_cast<float>(w[1]), to_c = static_cast<float>(w[2]);
    const Color color = a.color + to_b * (b.color - a.color) + to_c * (c.color - a.color);
    draw_point(image, depth, Point(x, y), static_cast<float>(a.z + w[1] * z_b + w[2] * z_c), color);
  };
  rasterize_wide_triangle(Corners{a.position, b.position, c.position}, image.width(),
                          image.height(), visit);
}

}  // namespace rasterlab

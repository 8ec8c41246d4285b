#include "common/zbuffer/draw_depth_triangle.h"

#include "common/image/check.h"
#include "common/triangles/rasterize.h"

namespace rasterlab {

void draw_depth_triangle(Image<Rgb8>& image, DepthBuffer& depth,
                         const std::array<DepthCorner, 3>& corners) {
  // <solution>
  const DepthCorner& a = corners[0];
  const DepthCorner& b = corners[1];
  const DepthCorner& c = corners[2];
  rasterize_wide_triangle({a.position, b.position, c.position}, image.width(), image.height(),
                          [&](int x, int y, const Eigen::Vector3d& weights) {
                            const double z = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
                            const Eigen::Vector3f w = weights.cast<float>();
                            draw_point(image, depth, {x, y}, static_cast<float>(z),
                                       w[0] * a.color + w[1] * b.color + w[2] * c.color);
                          });
  // <starter> throw NotWritten("03.4", image, depth, corners);
  // </solution>
}

}  // namespace rasterlab

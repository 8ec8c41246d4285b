// A right answer written differently: every pixel of the box is asked for its three weights, in 128
// bits.
#include "common/zbuffer/draw_depth_triangle.h"

#include "common/triangles/edge_function.h"
#include "common/triangles/pixel_box.h"

namespace rasterlab {

void draw_depth_triangle(Image<Rgb8>& image, DepthBuffer& depth,
                         const std::array<DepthCorner, 3>& corners) {
  const Corners positions = {corners[0].position, corners[1].position, corners[2].position};
  const auto triangle = make_edges<Int128>(snap(positions, max_wide_coordinate));
  if (triangle.twice_area == 0) return;
  const auto area = static_cast<double>(triangle.twice_area);
  const PixelBox box = pixel_box(positions, image.width(), image.height());
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      bool covered = true;
      double z = 0;
      Eigen::Vector3d color = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        const Int128 value = triangle.edges[i].at(x, y);
        covered = covered && value >= triangle.edges[i].threshold();
        const double weight = static_cast<double>(value) / area;
        z += weight * corners[i].z;
        color += weight * corners[i].color.cast<double>();
      }
      if (covered) {
        draw_point(image, depth, {x, y}, static_cast<float>(z), color.cast<float>());
      }
    }
  }
}

}  // namespace rasterlab

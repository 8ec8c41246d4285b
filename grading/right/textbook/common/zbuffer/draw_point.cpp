// A right answer written differently: one condition, each part after what it needs.
#include "common/zbuffer/draw_point.h"

namespace rasterlab {

void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color) {
  const int x = point[0], y = point[1];
  if (x >= 0 && y >= 0 && x < image.width() && y < image.height() && -1 <= z && z <= 1 &&
      depth.test(x, y, z)) {
    image(x, y) = to_rgb8(color);
    depth.write(x, y, z);
  }
}

}  // namespace rasterlab

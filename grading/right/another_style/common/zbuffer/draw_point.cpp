// A right answer written differently: one condition for all.
#include "common/zbuffer/draw_point.h"

#include "common/image/check.h"

namespace rasterlab {

void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color) {
  const int x = point.x(), y = point.y();
  const bool seen = image.contains(x, y) && -1 <= z && z <= 1 && depth.test(x, y, z);
  if (seen) {
    image(x, y) = to_rgb8(color);
    depth.write(x, y, z);
  }
}

}  // namespace rasterlab

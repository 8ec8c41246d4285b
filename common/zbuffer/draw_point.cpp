#include "common/zbuffer/draw_point.h"

namespace rasterlab {

void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color) {
  if (!image.contains(point.x(), point.y()) || !(z >= -1 && z <= 1)) return;
  if (!depth.test(point.x(), point.y(), z)) return;
  depth.write(point.x(), point.y(), z);
  image(point.x(), point.y()) = to_rgb8(color);
}

}  // namespace rasterlab

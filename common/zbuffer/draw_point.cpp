#include "common/zbuffer/draw_point.h"

#include "common/image/check.h"

namespace rasterlab {

void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color) {
  // <solution>
  if (!image.contains(point.x(), point.y()) || !(z >= -1 && z <= 1)) return;
  if (!depth.test(point.x(), point.y(), z)) return;
  depth.write(point.x(), point.y(), z);
  image(point.x(), point.y()) = to_rgb8(color);
  // <starter> throw NotWritten("03.2", image, depth, point, z, color);
  // </solution>
}

}  // namespace rasterlab

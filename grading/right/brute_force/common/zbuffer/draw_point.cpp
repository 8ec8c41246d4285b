// A right answer written differently: every reason not to draw by itself, with the stored depth
// read.
#include "common/zbuffer/draw_point.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {

void draw_point(Image<Rgb8>& image, DepthBuffer& depth, const Point& point, float z,
                const Color& color) {
  if (point.x() < 0 || point.y() < 0) return;
  if (point.x() >= image.width() || point.y() >= image.height()) return;
  if (std::isnan(z) || std::fabs(z) > 1) return;
  if (depth.depths()(point.x(), point.y()) <= z) return;
  image.row(point.y())[point.x()] = to_rgb8(color);
  depth.write(point.x(), point.y(), z);
}

}  // namespace rasterlab

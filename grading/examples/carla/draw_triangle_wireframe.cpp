#include "common/triangles/draw_triangle_wireframe.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  drawline(image, corners[0], corners[1], color)
}

}  // namespace rasterlab

#include "common/triangles/draw_triangle_wireframe.h"

#include "common/lines/draw_line.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  // from each corner to the next
  for (int i = 0; i < 2; i++) draw_line(image, corners[i], corners[i + 1], color);
}

}  // namespace rasterlab

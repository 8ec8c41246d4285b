// A right answer written differently: a loop over the corners, each with the one before.
#include "common/triangles/draw_triangle_wireframe.h"

#include "common/lines/draw_line.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  Point previous = corners.back();
  for (const Point& corner : corners) {
    draw_line(image, previous, corner, color);
    previous = corner;
  }
}

}  // namespace rasterlab

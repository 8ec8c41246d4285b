// A right answer written differently: corner after corner, each with the next.
#include "common/triangles/draw_triangle_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    draw_line(image, corners[i], corners[(i + 1) % corners.size()], color);
  }
}

}  // namespace rasterlab

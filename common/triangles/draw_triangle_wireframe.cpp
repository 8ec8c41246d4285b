#include "common/triangles/draw_triangle_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  // <solution>
  draw_line(image, corners[0], corners[1], color);
  draw_line(image, corners[1], corners[2], color);
  draw_line(image, corners[2], corners[0], color);
  // <starter> throw NotWritten("02.1", image, corners, color);
  // </solution>
}

}  // namespace rasterlab

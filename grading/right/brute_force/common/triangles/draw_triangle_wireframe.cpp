// A right answer written differently: the pixels of the three lines, those inside drawn one by one.
#include "common/triangles/draw_triangle_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"
#include "common/lines/line_all_octants.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  const std::array<LineDiscrete, 3> sides = {line_all_octants(corners[2], corners[0]),
                                             line_all_octants(corners[0], corners[1]),
                                             line_all_octants(corners[1], corners[2])};
  for (const LineDiscrete& side : sides) {
    for (const Point& pixel : side) {
      if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = color;
    }
  }
}

}  // namespace rasterlab

// A right answer written differently: the sides backwards, their pixels inside drawn one by one.
#include "common/triangles/draw_triangle_wireframe.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_triangle_wireframe(Image<Rgb8>& image, const std::array<Point, 3>& corners,
                             const Rgb8& color) {
  for (std::size_t i = 3; i-- > 0;) {
    const LineSteps side(corners[i], corners[(i + 1) % 3]);
    const StepRange seen = side.inside(image.width(), image.height(), 1);
    for (const Point& pixel : line_all_octants(corners[i], corners[(i + 1) % 3], seen)) {
      if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = color;
    }
  }
}

}  // namespace rasterlab

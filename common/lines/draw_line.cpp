#include "common/lines/draw_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"

namespace rasterlab {

void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color) {
  // <solution>
  const StepRange visible = LineSteps(p0, p1).inside(image.width(), image.height());
  for (const Point& pixel : line_all_octants(p0, p1, visible)) {
    image(pixel.x(), pixel.y()) = color;
  }
  // <starter> throw NotWritten("01.7", image, p0, p1, color);
  // </solution>
}

}  // namespace rasterlab

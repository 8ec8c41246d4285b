#include "common/lines/draw_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"

namespace rasterlab {

void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color) {
  // <solution>
  const StepRange near = LineSteps(p0, p1).inside(image.width(), image.height(), 1);
  for (const Point& pixel : line_all_octants(p0, p1, near)) {
    if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = color;
  }
  // <starter> throw NotWritten("01.7", image, p0, p1, color);
  // </solution>
}

}  // namespace rasterlab

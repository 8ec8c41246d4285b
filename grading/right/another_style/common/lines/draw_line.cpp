// A right answer written differently: the whole line is made, and each pixel asks whether it is
// inside.
#include "common/lines/draw_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"

namespace rasterlab {

void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color) {
  const LineDiscrete line = line_all_octants(p0, p1);
  for (const Point& pixel : line) {
    if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = color;
  }
}

}  // namespace rasterlab

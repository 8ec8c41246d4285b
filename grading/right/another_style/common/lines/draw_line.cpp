// A right answer written differently: from both ends of what is inside to the middle.
#include "common/lines/draw_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color) {
  const StepRange seen = LineSteps(p0, p1).inside(image.width(), image.height(), 1);
  const LineDiscrete line = line_all_octants(p0, p1, seen);
  for (std::size_t left = 0, right = line.size(); left < right; ++left) {
    for (const Point& pixel : {line[left], line[--right]}) {
      if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = color;
    }
  }
}

}  // namespace rasterlab

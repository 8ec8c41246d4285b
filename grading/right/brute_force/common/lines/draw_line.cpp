// A right answer written differently: drawn from its end to its start, straight into the rows.
#include "common/lines/draw_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"

namespace rasterlab {

void draw_line(Image<Rgb8>& image, const Point& p0, const Point& p1, const Rgb8& color) {
  const LineSteps segment(p0, p1);
  const StepRange seen = segment.inside(image.width(), image.height());
  for (std::int64_t step = seen.last; step >= seen.first; --step) {
    const Point pixel = segment.at(step);
    *(image.row(pixel.y()) + pixel.x()) = color;
  }
}

}  // namespace rasterlab

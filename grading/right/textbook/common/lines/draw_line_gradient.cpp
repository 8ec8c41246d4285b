// A right answer written differently: the part of the line that is inside, each pixel from one
// colour toward the other.
#include "common/lines/draw_line_gradient.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1) {
  const StepRange seen = LineSteps(p0, p1).inside(image.width(), image.height(), 1);
  const LineDiscrete line = line_all_octants(p0, p1, seen);
  const LineInterpolation alpha(line, p0, p1);
  for (std::size_t i = 0; i < line.size(); i++) {
    if (!image.contains(line[i].x(), line[i].y())) continue;
    image(line[i].x(), line[i].y()) = to_rgb8(c0 + static_cast<float>(alpha[i]) * (c1 - c0));
  }
}

}  // namespace rasterlab

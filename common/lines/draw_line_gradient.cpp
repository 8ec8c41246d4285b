#include "common/lines/draw_line_gradient.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"

namespace rasterlab {

void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1) {
  // <solution>
  const StepRange near = LineSteps(p0, p1).inside(image.width(), image.height(), 1);
  const LineDiscrete line = line_all_octants(p0, p1, near);
  const LineInterpolation weights(line, p0, p1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!image.contains(line[i].x(), line[i].y())) continue;
    const auto weight = static_cast<float>(weights[i]);
    image(line[i].x(), line[i].y()) = to_rgb8((1 - weight) * c0 + weight * c1);
  }
  // <starter> throw NotWritten("01.10", image, p0, c0, p1, c1);
  // </solution>
}

}  // namespace rasterlab

#include "common/zbuffer/draw_depth_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"

namespace rasterlab {

void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b) {
  // <solution>
  const StepRange near = LineSteps(a.pixel, b.pixel).inside(image.width(), image.height(), 1);
  const LineDiscrete line = line_all_octants(a.pixel, b.pixel, near);
  const LineInterpolation weights(line, a.pixel, b.pixel);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto weight = static_cast<float>(weights[i]);
    draw_point(image, depth, line[i], (1 - weight) * a.z + weight * b.z,
               (1 - weight) * a.color + weight * b.color);
  }
  // <starter> throw NotWritten("03.3", image, depth, a, b);
  // </solution>
}

}  // namespace rasterlab

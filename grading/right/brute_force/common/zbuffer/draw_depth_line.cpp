// A right answer written differently: each pixel is a line of its own, from the end to the start.
#include "common/zbuffer/draw_depth_line.h"

#include "common/image/check.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b) {
  const LineSteps segment(a.pixel, b.pixel);
  const StepRange seen = segment.inside(image.width(), image.height());
  for (std::int64_t k = seen.last; k >= seen.first; --k) {
    const LineDiscrete one = {segment.at(k)};
    const auto t = static_cast<float>(LineInterpolation(one, a.pixel, b.pixel)[0]);
    draw_point(image, depth, one[0], a.z + t * (b.z - a.z), a.color + t * (b.color - a.color));
  }
}

}  // namespace rasterlab

// A right answer written differently: from p1 back to p0, channel by channel.
#include "common/lines/draw_line_gradient.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1) {
  const LineSteps segment(p0, p1);
  const StepRange seen = segment.inside(image.width(), image.height());
  for (std::int64_t k = seen.last; k >= seen.first; --k) {
    const LineDiscrete one = {segment.at(k)};
    const double alpha = LineInterpolation(one, p0, p1)[0];
    Color color;
    for (int channel = 0; channel < 3; ++channel) {
      color[channel] =
          static_cast<float>((1 - alpha) * double(c0[channel]) + alpha * double(c1[channel]));
    }
    image(one[0].x(), one[0].y()) = to_rgb8(color);
  }
}

}  // namespace rasterlab

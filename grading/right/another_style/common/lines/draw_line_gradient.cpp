// A right answer written differently: step by step in doubles, from c0 toward c1.
#include "common/lines/draw_line_gradient.h"

#include "common/lines/line_steps.h"

#include <cmath>

namespace rasterlab {

void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1) {
  const LineSteps segment(p0, p1);
  const StepRange seen = segment.inside(image.width(), image.height());
  const double length = std::hypot(double(p1.x()) - p0.x(), double(p1.y()) - p0.y());
  for (std::int64_t k = seen.first; k <= seen.last; ++k) {
    const Point p = segment.at(k);
    const double gone = std::hypot(double(p.x()) - p0.x(), double(p.y()) - p0.y());
    const double weight = length == 0 ? 0 : gone / length;
    const Eigen::Vector3d from = c0.cast<double>(), to = c1.cast<double>();
    image(p.x(), p.y()) = to_rgb8((from + weight * (to - from)).cast<float>());
  }
}

}  // namespace rasterlab

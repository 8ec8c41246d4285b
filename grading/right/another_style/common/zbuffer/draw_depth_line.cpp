// A right answer written differently: step by step, in doubles.
#include "common/zbuffer/draw_depth_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"

namespace rasterlab {

void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b) {
  const LineSteps segment(a.pixel, b.pixel);
  const StepRange seen = segment.inside(image.width(), image.height());
  const double whole = (b.pixel.cast<double>() - a.pixel.cast<double>()).norm();
  for (std::int64_t k = seen.first; k <= seen.last; ++k) {
    const Point pixel = segment.at(k);
    const double gone = (pixel.cast<double>() - a.pixel.cast<double>()).norm();
    const double share = whole > 0 ? gone / whole : 0;
    const double z = a.z + share * (static_cast<double>(b.z) - a.z);
    const Eigen::Vector3d color =
        (1 - share) * a.color.cast<double>() + share * b.color.cast<double>();
    draw_point(image, depth, pixel, static_cast<float>(z), color.cast<float>());
  }
}

}  // namespace rasterlab

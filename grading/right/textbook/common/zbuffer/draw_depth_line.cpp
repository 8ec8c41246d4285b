// A right answer written differently: step by step, with no list of pixels or weights.
#include "common/zbuffer/draw_depth_line.h"

#include "common/lines/line_steps.h"

namespace rasterlab {

void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b) {
  const LineSteps segment(a.pixel, b.pixel);
  const Eigen::Vector2d start = a.pixel.cast<double>();
  const double length = (b.pixel.cast<double>() - start).norm();
  const StepRange seen = segment.inside(image.width(), image.height());
  for (std::int64_t k = seen.first; k <= seen.last; ++k) {
    const Point pixel = segment.at(k);
    const double t = length > 0 ? (pixel.cast<double>() - start).norm() / length : 0;
    const double z = a.z + t * (double(b.z) - a.z);
    const Eigen::Vector3d color = a.color.cast<double>() * (1 - t) + b.color.cast<double>() * t;
    draw_point(image, depth, pixel, static_cast<float>(z), color.cast<float>());
  }
}

}  // namespace rasterlab

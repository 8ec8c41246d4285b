#include "common/lines/fixed_steps.h"

namespace rasterlab {
namespace {

LineDiscrete in_steps(const Point& p0, const Point& p1, int steps) {
  const Eigen::Vector2d start = p0.cast<double>();
  const Eigen::Vector2d way = p1.cast<double>() - start;
  LineDiscrete line;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d point = start + way * i / steps;
    line.append(point.cast<int>());
  }
  return line;
}

}  // namespace

LineDiscrete line_hundred_steps(const Point& p0, const Point& p1) {
  return in_steps(p0, p1, 100);
}

LineDiscrete line_ten_steps(const Point& p0, const Point& p1) {
  return in_steps(p0, p1, 10);
}

}  // namespace rasterlab

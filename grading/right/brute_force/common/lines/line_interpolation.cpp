// A right answer written differently: in long doubles, one pixel after the other.
#include "common/lines/line_interpolation.h"

#include "common/image/check.h"

#include <cmath>
#include <ostream>
#include <string>

namespace rasterlab {

LineInterpolation::LineInterpolation(const LineDiscrete& line) {
  if (!line.empty()) *this = LineInterpolation(line, line[0], line[line.size() - 1]);
}

LineInterpolation::LineInterpolation(const LineDiscrete& pixels, const Point& p0, const Point& p1) {
  weights_.resize(pixels.size());
  const long double x = static_cast<long double>(p1.x()) - p0.x();
  const long double y = static_cast<long double>(p1.y()) - p0.y();
  for (std::size_t i = 0; i < pixels.size() && (x != 0 || y != 0); ++i) {
    const long double dx = static_cast<long double>(pixels[i].x()) - p0.x();
    const long double dy = static_cast<long double>(pixels[i].y()) - p0.y();
    weights_[i] = static_cast<double>(std::sqrt(dx * dx + dy * dy) / std::sqrt(x * x + y * y));
  }
}

double LineInterpolation::operator[](std::size_t index) const {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    if (i == index) return weights_[i];
  }
  throw CheckError("the line has no weight " + std::to_string(index));
}

std::ostream& operator<<(std::ostream& out, const LineInterpolation& interpolation) {
  if (interpolation.size() > 0) out << interpolation[0];
  for (std::size_t i = 1; i < interpolation.size(); ++i) out << ' ' << interpolation[i];
  return out;
}

}  // namespace rasterlab

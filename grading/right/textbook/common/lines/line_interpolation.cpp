// A right answer written differently: distances by Pythagoras, and a separator that changes.
#include "common/lines/line_interpolation.h"

#include "common/image/check.h"

#include <cmath>
#include <ostream>

namespace rasterlab {

LineInterpolation::LineInterpolation(const LineDiscrete& line) {
  if (!line.empty()) *this = LineInterpolation(line, *line.begin(), *line.rbegin());
}

LineInterpolation::LineInterpolation(const LineDiscrete& pixels, const Point& p0, const Point& p1) {
  const auto distance = [&p0](const Point& p) {
    return std::hypot(double(p.x()) - p0.x(), double(p.y()) - p0.y());
  };
  for (const Point& pixel : pixels) {
    weights_.push_back(p0 == p1 ? 0 : distance(pixel) / distance(p1));
  }
}

double LineInterpolation::operator[](std::size_t index) const {
  if (index < weights_.size()) return weights_[index];
  throw CheckError("no such weight");
}

std::ostream& operator<<(std::ostream& out, const LineInterpolation& interpolation) {
  const char* separator = "";
  for (std::size_t i = 0; i < interpolation.size(); i++) {
    out << separator << interpolation[i];
    separator = " ";
  }
  return out;
}

}  // namespace rasterlab

// A right answer written differently: squares of distances are divided, then the root is taken.
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
  const auto squared = [&p0](const Point& p) {
    const double dx = static_cast<double>(p.x()) - p0.x();
    const double dy = static_cast<double>(p.y()) - p0.y();
    return dx * dx + dy * dy;
  };
  const double whole = squared(p1);
  for (const Point& pixel : pixels) {
    weights_.push_back(whole == 0 ? 0 : std::sqrt(squared(pixel) / whole));
  }
}

double LineInterpolation::operator[](std::size_t index) const {
  if (index >= size()) throw CheckError("fewer pixels than that");
  return *(weights_.begin() + static_cast<std::ptrdiff_t>(index));
}

std::ostream& operator<<(std::ostream& out, const LineInterpolation& interpolation) {
  std::size_t left = interpolation.size();
  for (std::size_t i = 0; i < interpolation.size(); ++i) {
    out << interpolation[i];
    if (--left > 0) out << ' ';
  }
  return out;
}

}  // namespace rasterlab

#include "common/lines/line_interpolation.h"

#include "common/image/check.h"

#include <ostream>
#include <string>

namespace rasterlab {

LineInterpolation::LineInterpolation(const LineDiscrete& line) {
  if (!line.empty()) *this = LineInterpolation(line, line[0], line[line.size() - 1]);
}

LineInterpolation::LineInterpolation(const LineDiscrete& pixels, const Point& p0, const Point& p1) {
  // <solution>
  const Eigen::Vector2d start = p0.cast<double>();
  const double length = (p1.cast<double>() - start).norm();
  for (const Point& pixel : pixels) {
    weights_.push_back(length > 0 ? (pixel.cast<double>() - start).norm() / length : 0.0);
  }
  // <starter> throw NotWritten("01.9", pixels, p0, p1);
  // </solution>
}

double LineInterpolation::operator[](std::size_t index) const {
  // <solution>
  if (index >= weights_.size()) {
    throw CheckError("weight " + std::to_string(index) + " of a line of " +
                     std::to_string(weights_.size()) + " pixels");
  }
  return weights_[index];
  // <starter> throw NotWritten("01.9", index);
  // </solution>
}

std::ostream& operator<<(std::ostream& out, const LineInterpolation& interpolation) {
  // <solution>
  for (std::size_t i = 0; i < interpolation.size(); ++i) {
    out << (i == 0 ? "" : " ") << interpolation[i];
  }
  return out;
  // <starter> throw NotWritten("01.9", out, interpolation);
  // </solution>
}

}  // namespace rasterlab

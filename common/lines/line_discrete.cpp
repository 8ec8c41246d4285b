#include "common/lines/line_discrete.h"

#include "common/image/check.h"

#include <ostream>
#include <string>

namespace rasterlab {

void LineDiscrete::append(const Point& pixel) {
  pixels_.push_back(pixel);
}

const Point& LineDiscrete::operator[](std::size_t index) const {
  if (index >= pixels_.size()) {
    throw CheckError("pixel " + std::to_string(index) + " of a line of " +
                     std::to_string(pixels_.size()) + " pixels");
  }
  return pixels_[index];
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  for (const Point& pixel : line) out << '(' << pixel.x() << ',' << pixel.y() << ')';
  return out;
}

}  // namespace rasterlab

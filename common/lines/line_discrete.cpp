#include "common/lines/line_discrete.h"

#include "common/image/check.h"

#include <ostream>
#include <string>

namespace rasterlab {

void LineDiscrete::append(const Point& pixel) {
  // <solution>
  pixels_.push_back(pixel);
  // <starter> throw NotWritten("01.4", pixel);
  // </solution>
}

const Point& LineDiscrete::operator[](std::size_t index) const {
  // <solution>
  if (index >= pixels_.size()) {
    throw CheckError("pixel " + std::to_string(index) + " of a line of " +
                     std::to_string(pixels_.size()) + " pixels");
  }
  return pixels_[index];
  // <starter> throw NotWritten("01.4", index);
  // </solution>
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  // <solution>
  for (const Point& pixel : line) out << '(' << pixel.x() << ',' << pixel.y() << ')';
  return out;
  // <starter> throw NotWritten("01.4", out, line);
  // </solution>
}

}  // namespace rasterlab

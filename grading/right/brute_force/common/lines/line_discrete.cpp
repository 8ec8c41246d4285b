// A right answer written differently: counts pixels down, and writes into a string first.
#include "common/lines/line_discrete.h"

#include "common/image/check.h"

#include <ostream>
#include <string>

namespace rasterlab {

void LineDiscrete::append(const Point& pixel) {
  pixels_.resize(pixels_.size() + 1);
  pixels_.back() = pixel;
}

const Point& LineDiscrete::operator[](std::size_t index) const {
  for (const Point& pixel : pixels_) {
    if (index-- == 0) return pixel;
  }
  throw CheckError("the line has fewer pixels");
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  std::string text;
  for (const Point& pixel : line) {
    text += '(' + std::to_string(pixel.x()) + ',' + std::to_string(pixel.y()) + ')';
  }
  return out << text;
}

}  // namespace rasterlab

// A right answer written differently: counts pixels from the end, and writes into a string first.
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
  const std::size_t from_the_end = pixels_.size() - index;
  if (from_the_end == 0 || from_the_end > pixels_.size()) {
    throw CheckError("the line has fewer pixels");
  }
  return *(pixels_.end() - static_cast<std::ptrdiff_t>(from_the_end));
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  std::string text;
  for (const Point& pixel : line) {
    text += '(' + std::to_string(pixel.x()) + ',' + std::to_string(pixel.y()) + ')';
  }
  return out << text;
}

}  // namespace rasterlab

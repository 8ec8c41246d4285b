// A right answer written differently: in place, by index and by the container itself.
#include "common/lines/line_discrete.h"

#include "common/image/check.h"

#include <ostream>
#include <string>

namespace rasterlab {

void LineDiscrete::append(const Point& pixel) {
  pixels_.emplace_back(pixel.x(), pixel.y());
}

const Point& LineDiscrete::operator[](std::size_t index) const {
  if (index < size()) return *(begin() + static_cast<std::ptrdiff_t>(index));
  throw CheckError("there is no such pixel");
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  for (const Point& pixel : line) out << "(" << pixel.x() << "," << pixel.y() << ")";
  return out;
}

}  // namespace rasterlab

// A right answer written differently: the container's own check, and iterators instead of a range.
#include "common/lines/line_discrete.h"

#include "common/image/check.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace rasterlab {

void LineDiscrete::append(const Point& pixel) {
  pixels_.insert(pixels_.end(), pixel);
}

const Point& LineDiscrete::operator[](std::size_t index) const {
  try {
    return pixels_.at(index);
  } catch (const std::out_of_range& error) {
    throw CheckError(error.what());
  }
}

std::ostream& operator<<(std::ostream& out, const LineDiscrete& line) {
  std::for_each(line.begin(), line.end(),
                [&](const Point& pixel) { out << "(" << pixel[0] << "," << pixel[1] << ")"; });
  return out;
}

}  // namespace rasterlab

// Asks for an object of gigabytes.
#include "common/lines/draw_line.h"

volatile char filled[std::size_t{1} << 33U] = {1};

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {}

}  // namespace rasterlab

// Brings its own main().
#include "common/lines/draw_line.h"

int main() {
  return 0;
}

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {}

}  // namespace rasterlab

// Recurses for ever.
#include "common/lines/draw_line.h"

namespace {
int deeper(volatile int* above) {
  volatile int here[1000] = {};
  here[0] = *above + 1;
  return deeper(here) + here[0];
}
}  // namespace

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {
  volatile int start = 0;
  deeper(&start);
}

}  // namespace rasterlab

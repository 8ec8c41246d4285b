// Computes for ever.
#include "common/lines/draw_line.h"

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {
  for (volatile int i = 0;; i = i + 1) {
  }
}

}  // namespace rasterlab

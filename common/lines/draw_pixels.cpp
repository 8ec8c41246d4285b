#include "common/lines/draw_pixels.h"

namespace rasterlab {

std::int64_t draw_pixels(Image<Rgb8>& image, const LineDiscrete& line, const Rgb8& color) {
  std::int64_t drawn = 0;
  for (const Point& pixel : line) {
    if (!image.contains(pixel.x(), pixel.y())) continue;
    image(pixel.x(), pixel.y()) = color;
    ++drawn;
  }
  return drawn;
}

}  // namespace rasterlab

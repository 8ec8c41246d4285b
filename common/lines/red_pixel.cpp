#include "common/lines/red_pixel.h"

namespace rasterlab {

Image<Rgb8> red_pixel(int width, int height, int x, int y_up) {
  Image<Rgb8> image(width, height);
  image(x, height - 1 - y_up) = Rgb8{255, 0, 0};
  return image;
}

}  // namespace rasterlab

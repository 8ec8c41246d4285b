#include "common/lines/red_pixel.h"

#include "common/image/check.h"

namespace rasterlab {

Image<Rgb8> red_pixel(int width, int height, int x, int y_up) {
  // <solution>
  Image<Rgb8> image(width, height);
  image(x, height - 1 - y_up) = Rgb8{255, 0, 0};
  return image;
  // <starter> throw NotWritten("01.2", width, height, x, y_up);
  // </solution>
}

}  // namespace rasterlab

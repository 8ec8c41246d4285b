// A right answer written differently: the rows are counted down until the one asked for.
#include "common/lines/red_pixel.h"

namespace rasterlab {

Image<Rgb8> red_pixel(int width, int height, int x, int y_up) {
  Image<Rgb8> image(width, height, Rgb8{0, 0, 0});
  int row = height - 1;
  for (int from_bottom = 0; from_bottom < y_up && row >= 0; ++from_bottom) --row;
  if (y_up < 0) row = -1;
  image(x, row).r = 255;
  return image;
}

}  // namespace rasterlab

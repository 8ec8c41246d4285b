// A right answer written differently: the place of the pixel among all, row after row.
#include "common/lines/red_pixel.h"

#include "common/image/check.h"

namespace rasterlab {

Image<Rgb8> red_pixel(int width, int height, int x, int y_up) {
  if (x < 0 || x >= width || y_up < 0 || y_up >= height) throw CheckError("no such pixel");
  Image<Rgb8> image(width, height);
  const std::size_t rows_above = static_cast<std::size_t>(height - y_up) - 1;
  image.pixels()[rows_above * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = {
      255, 0, 0};
  return image;
}

}  // namespace rasterlab

// A right answer written differently: of the 256 greys the nearest is looked for.
#include "common/lines/fading_column.h"

#include "common/image/check.h"

#include <algorithm>
#include <cstdlib>

namespace rasterlab {

void draw_fading_column(Image<Rgb8>& image, int x) {
  const int last = image.height() - 1;
  for (int y = 0; y <= last; ++y) {
    int nearest = 0;
    for (int grey = 1; grey < 256; ++grey) {
      if (std::abs(grey * last - 255 * y) < std::abs(nearest * last - 255 * y)) nearest = grey;
    }
    Rgb8& pixel = image(x, y);
    pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(nearest);
  }
}

}  // namespace rasterlab

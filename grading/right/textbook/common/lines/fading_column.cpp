// A right answer written differently: in doubles, rounded by the library.
#include "common/lines/fading_column.h"

#include "common/image/check.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

void draw_fading_column(Image<Rgb8>& image, int x) {
  for (int y = 0; y < image.height(); ++y) {
    const double share = y == 0 ? 0.0 : static_cast<double>(y) / (image.height() - 1);
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * share));
    image(x, y) = Rgb8{grey, grey, grey};
  }
}

}  // namespace rasterlab

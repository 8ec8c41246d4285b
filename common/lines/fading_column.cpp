#include "common/lines/fading_column.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {

void draw_fading_column(Image<Rgb8>& image, int x) {
  // <solution>
  const float last = static_cast<float>(std::max(image.height() - 1, 1));
  for (int y = 0; y < image.height(); ++y) {
    image(x, y) = to_rgb8(Color::Constant(static_cast<float>(y) / last));
  }
  // <starter> throw NotWritten("01.3", image, x);
  // </solution>
}

}  // namespace rasterlab

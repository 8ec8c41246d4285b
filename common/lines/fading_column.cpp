#include "common/lines/fading_column.h"

#include <algorithm>

namespace rasterlab {

void draw_fading_column(Image<Rgb8>& image, int x) {
  const float last = static_cast<float>(std::max(image.height() - 1, 1));
  for (int y = 0; y < image.height(); ++y) {
    image(x, y) = to_rgb8(Color::Constant(static_cast<float>(y) / last));
  }
}

}  // namespace rasterlab

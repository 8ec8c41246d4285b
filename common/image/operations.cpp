#include "common/image/operations.h"

#include "common/image/pixel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlab {

Image<std::uint8_t> grey_picture(const Image<float>& values, float black, float white) {
  if (black == white || !std::isfinite(black) || !std::isfinite(white)) {
    throw CheckError("grey_picture needs two different finite values for black and white, not " +
                     std::to_string(black) + " and " + std::to_string(white));
  }
  Image<std::uint8_t> result(values.width(), values.height());
  std::transform(values.pixels().begin(), values.pixels().end(), result.pixels().begin(),
                 [=](float value) { return to_byte((value - black) / (white - black)); });
  return result;
}

std::pair<float, float> finite_range(const Image<float>& values) {
  float least = std::numeric_limits<float>::infinity();
  float greatest = -least;
  for (const float value : values.pixels()) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  if (least > greatest) return {0, 0};
  return {least, greatest};
}

}  // namespace rasterlab

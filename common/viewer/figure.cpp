#include "common/viewer/figure.h"

#include "common/image/operations.h"

#include <limits>

namespace rasterlab {

Frame frame_of(const Run& run, Size fallback) {
  const Size size = run.size(fallback);
  return make_frame(size.width, size.height);
}

float aspect_of(const Frame& frame) {
  return static_cast<float>(frame.width()) / static_cast<float>(frame.height());
}

Image<std::uint8_t> depth_picture(const Frame& frame) {
  Image<float> drawn = frame.depth.depths();
  for (float& depth : drawn.pixels()) {
    if (depth == 1) depth = std::numeric_limits<float>::infinity();
  }
  const auto [nearest, farthest] = finite_range(drawn);
  const float background = farthest + 0.25F * (farthest - nearest) + 1e-6F;
  return grey_picture(drawn, background, nearest);
}

}  // namespace rasterlab

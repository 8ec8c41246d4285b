// A right answer written differently: all pixels of the line, in or out: draw_point() knows which
// are inside.
#include "common/zbuffer/draw_depth_line.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"

namespace rasterlab {

void draw_depth_line(Image<Rgb8>& image, DepthBuffer& depth, const LineEnd& a, const LineEnd& b) {
  const LineDiscrete pixels = line_all_octants(a.pixel, b.pixel);
  const LineInterpolation alpha(pixels);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto t = static_cast<float>(alpha[i]);
    draw_point(image, depth, pixels[i], a.z + t * (b.z - a.z), a.color + t * (b.color - a.color));
  }
}

}  // namespace rasterlab

// A right answer written differently: the whole line with its weights, of which only what is inside
// is drawn.
#include "common/lines/draw_line_gradient.h"

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"

namespace rasterlab {

void draw_line_gradient(Image<Rgb8>& image, const Point& p0, const Color& c0, const Point& p1,
                        const Color& c1) {
  const LineDiscrete line = line_all_octants(p0, p1);
  const LineInterpolation alpha(line);
  for (std::size_t i = 0; i < line.size(); i++) {
    const int x = line[i].x(), y = line[i].y();
    if (!image.contains(x, y)) continue;
    image(x, y) = to_rgb8(c0 + static_cast<float>(alpha[i]) * (c1 - c0));
  }
}

}  // namespace rasterlab

#include "common/triangles/fill_half_sweep.h"

#include "common/triangles/fill_sweep.h"
#include "common/triangles/pixel_corners.h"

#include <algorithm>

namespace rasterlab {

void fill_half_sweep(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  std::array<Point, 3> sorted = pixel_corners(corners);
  std::sort(sorted.begin(), sorted.end(),
            [](const Point& a, const Point& b) { return a.y() < b.y(); });
  const auto& [top, middle, bottom] = sorted;
  for (int y = std::max(top.y(), 0); y <= std::min(middle.y(), image.height() - 1); ++y) {
    sweep_row(image, y, {top, bottom}, {top, middle}, color);
  }
}

}  // namespace rasterlab

#include "common/triangles/fill_sweep.h"

#include "common/triangles/pixel_corners.h"

#include <algorithm>

namespace rasterlab {

void sweep_row(Image<Rgb8>& image, int y, const std::array<Point, 2>& side,
               const std::array<Point, 2>& other, const Rgb8& color) {
  int left = std::numeric_limits<int>::max();
  int right = std::numeric_limits<int>::min();
  const auto extend = [&](double x) {
    left = std::min(left, static_cast<int>(x));
    right = std::max(right, static_cast<int>(x));
  };
  for (const auto& [above, below] : {side, other}) {
    const double height = static_cast<double>(below.y()) - above.y();
    if (height > 0) {
      const double t = (static_cast<double>(y) - above.y()) / height;
      extend(above.x() + (static_cast<double>(below.x()) - above.x()) * t);
    } else {
      extend(above.x());
      extend(below.x());
    }
  }
  for (int x = std::max(left, 0); x <= std::min(right, image.width() - 1); ++x) image(x, y) = color;
}

void fill_sweep(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  std::array<Point, 3> sorted = pixel_corners(corners);
  std::sort(sorted.begin(), sorted.end(),
            [](const Point& a, const Point& b) { return a.y() < b.y(); });
  const auto& [top, middle, bottom] = sorted;
  const int first = std::max(top.y(), 0);
  const int last = std::min(bottom.y(), image.height() - 1);
  for (int y = first; y <= std::min(middle.y(), last); ++y) {
    sweep_row(image, y, {top, bottom}, {top, middle}, color);
  }
  for (int y = std::max(middle.y(), first); y <= last; ++y) {
    sweep_row(image, y, {top, bottom}, {middle, bottom}, color);
  }
}

}  // namespace rasterlab

#include "common/lines/draw_line_runs.h"

#include "common/lines/bresenham.h"
#include "common/lines/line_steps.h"
#include "common/lines/swapped_columns.h"

#include <cstdint>
#include <cstdlib>

namespace rasterlab {

std::int64_t draw_line_runs(Image<Rgb8>& image, const Point& p0, const Point& p1,
                            const Rgb8& color) {
  // <solution>
  const TurnedSegment segment = turn(p0, p1);
  const auto& [from, to, transposed] = segment;
  const LineSteps steps(segment.turned_back(from.x(), from.y()),
                        segment.turned_back(to.x(), to.y()));
  const StepRange visible = steps.inside(image.width(), image.height());
  if (visible.empty()) return 0;

  const std::int64_t columns = std::int64_t{to.x()} - from.x();
  const std::int64_t rows = std::abs(std::int64_t{to.y()} - from.y());
  const std::int64_t row = image.width();
  const std::int64_t minor = to.y() < from.y() ? -1 : 1;
  const std::int64_t along = transposed ? row : 1;
  const std::int64_t across = minor * (transposed ? 1 : row);
  const Point start = steps.at(visible.first);
  Rgb8* pixel = image.row(start.y()) + start.x();
  const auto whole = static_cast<std::uint64_t>(2 * columns);
  const std::int64_t step = 2 * rows;
  std::int64_t error = -columns;
  if (whole > 0) {
    error = static_cast<std::int64_t>(
                (static_cast<std::uint64_t>(visible.first) * static_cast<std::uint64_t>(step) +
                 static_cast<std::uint64_t>(columns)) %
                whole) -
            2 * columns;
  }
  for (std::int64_t k = visible.first; k <= visible.last; ++k) {
    *pixel = color;
    pixel += along;
    error += step;
    if (error >= 0) {
      pixel += across;
      error -= 2 * columns;
    }
  }
  return visible.last - visible.first + 1;
  // <starter> std::int64_t drawn = 0;
  // <starter> for (const Point& pixel : line_bresenham(p0, p1)) {
  // <starter>   if (!image.contains(pixel.x(), pixel.y())) continue;
  // <starter>   image(pixel.x(), pixel.y()) = color;
  // <starter>   ++drawn;
  // <starter> }
  // <starter> return drawn;
  // </solution>
}

}  // namespace rasterlab

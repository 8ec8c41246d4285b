// A right answer written differently: all vertices are put into the window first, then every side
// of every face is drawn.
#include "common/lines/draw_wireframe.h"

#include "common/lines/draw_line.h"
#include "common/lines/seen_along_z.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace rasterlab {
namespace {

int pixel_of(double coordinate, int size) {
  if (coordinate == size) return size - 1;
  const double limit = max_point_coordinate;
  return static_cast<int>(std::floor(std::min(std::max(coordinate, -limit), limit)));
}

}  // namespace

void draw_wireframe(Image<Rgb8>& image, const Mesh& mesh, const Rgb8& color) {
  std::vector<std::optional<Point>> pixels;
  for (const Eigen::Vector3f& position : mesh.positions) {
    const Eigen::Vector2f window = seen_along_z(position, image.width(), image.height());
    pixels.emplace_back();
    if (!window.hasNaN()) {
      pixels.back() =
          Point(pixel_of(window.x(), image.width()), pixel_of(window.y(), image.height()));
    }
  }
  for (const Mesh::Triangle& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &from = pixels[corners[i]], &to = pixels[corners[(i + 1) % 3]];
      if (from && to) draw_line(image, *from, *to, color);
    }
  }
}

}  // namespace rasterlab

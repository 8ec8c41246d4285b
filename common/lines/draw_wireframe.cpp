#include "common/lines/draw_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"
#include "common/lines/seen_along_z.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {
// <solution>
namespace {

/// The pixel a window coordinate falls into, in an image of `size` pixels.
int pixel_at(float coordinate, int size) {
  if (coordinate == static_cast<float>(size)) return size - 1;
  constexpr auto limit = static_cast<float>(max_point_coordinate);
  return static_cast<int>(std::clamp(std::floor(coordinate), -limit, limit));
}

}  // namespace
// </solution>

void draw_wireframe(Image<Rgb8>& image, const Mesh& mesh, const Rgb8& color) {
  // <solution>
  const auto draw_edge = [&](std::uint32_t from, std::uint32_t to) {
    const auto window = [&](std::uint32_t vertex) {
      return seen_along_z(mesh.positions[vertex], image.width(), image.height());
    };
    const auto pixel = [&](const Eigen::Vector2f& point) {
      return Point(pixel_at(point.x(), image.width()), pixel_at(point.y(), image.height()));
    };
    if (window(from).hasNaN() || window(to).hasNaN()) return;
    draw_line(image, pixel(window(from)), pixel(window(to)), color);
  };
  for (const Mesh::Triangle& corners : mesh.triangles) {
    draw_edge(corners[0], corners[1]);
    draw_edge(corners[1], corners[2]);
    draw_edge(corners[2], corners[0]);
  }
  // <starter> throw NotWritten("01.11", image, mesh, color);
  // </solution>
}

}  // namespace rasterlab

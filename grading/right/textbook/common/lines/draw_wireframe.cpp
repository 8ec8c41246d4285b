// A right answer written differently: the window by its own formula, corner after corner round each
// face.
#include "common/lines/draw_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"
#include "common/lines/seen_along_z.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

void draw_wireframe(Image<Rgb8>& image, const Mesh& mesh, const Rgb8& color) {
  const auto pixel = [](float coordinate, int size) {
    const auto end = static_cast<float>(size);
    if (coordinate == end) return size - 1;
    const auto limit = static_cast<float>(max_point_coordinate);
    if (coordinate < -limit) return -max_point_coordinate;
    if (coordinate > limit) return max_point_coordinate;
    return static_cast<int>(std::floor(coordinate));
  };
  for (const auto& triangle : mesh.triangles) {
    std::uint32_t from = triangle[2];
    for (const std::uint32_t to : triangle) {
      const Eigen::Vector2f a = seen_along_z(mesh.positions[from], image.width(), image.height());
      const Eigen::Vector2f b = seen_along_z(mesh.positions[to], image.width(), image.height());
      if (!a.hasNaN() && !b.hasNaN()) {
        // The direction is the face's own: of two equally near pixels it decides.
        draw_line(image, {pixel(a.x(), image.width()), pixel(a.y(), image.height())},
                  {pixel(b.x(), image.width()), pixel(b.y(), image.height())}, color);
      }
      from = to;
    }
  }
}

}  // namespace rasterlab

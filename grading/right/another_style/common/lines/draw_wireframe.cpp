// A right answer written differently: a list of the sides first, then all are drawn.
#include "common/lines/draw_wireframe.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"
#include "common/lines/seen_along_z.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rasterlab {
namespace {

struct Side {
  Point from;
  Point to;
};

int clamped(float coordinate, int size) {
  const double limit = max_point_coordinate;
  const double whole = std::floor(double(coordinate)) - (double(coordinate) == size ? 1 : 0);
  return static_cast<int>(whole < -limit ? -limit : whole > limit ? limit : whole);
}

}  // namespace

void draw_wireframe(Image<Rgb8>& image, const Mesh& mesh, const Rgb8& color) {
  std::vector<Side> sides;
  for (const Mesh::Triangle& corners : mesh.triangles) {
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
      std::array<Point, 2> ends;
      bool known = true;
      for (const auto& [end, corner] : {std::pair(0, i), std::pair(1, j)}) {
        const Eigen::Vector3f& position = mesh.positions[corners[std::size_t(corner)]];
        const Eigen::Vector2f at = seen_along_z(position, image.width(), image.height());
        known = known && !std::isnan(at.x()) && !std::isnan(at.y());
        if (known)
          ends[std::size_t(end)] = {clamped(at.x(), image.width()),
                                    clamped(at.y(), image.height())};
      }
      if (known) sides.push_back({ends[0], ends[1]});
    }
  }
  for (const Side& side : sides) draw_line(image, side.from, side.to, color);
}

}  // namespace rasterlab

#include "common/triangles/fill_edge_functions.h"

#include "common/image/check.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/pixel_box.h"

#include <algorithm>

namespace rasterlab {

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  // <solution>
  const TriangleEdges triangle = make_edges(snap(corners));
  if (triangle.twice_area == 0) return;
  const PixelBox box = pixel_box(corners, image.width(), image.height());
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      const bool covered =
          std::all_of(triangle.edges.begin(), triangle.edges.end(),
                      [&](const EdgeFunction& edge) { return edge.at(x, y) >= edge.threshold(); });
      if (covered) image(x, y) = color;
    }
  }
  // <starter> throw NotWritten("02.4", image, corners, color);
  // </solution>
}

}  // namespace rasterlab

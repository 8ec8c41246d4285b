#include "common/triangles/fill_edge_functions.h"

#include "common/triangles/edge_function.h"

namespace rasterlab {

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const TriangleEdges t = make_edges(snap(corners));
  if (t.twice_area == 0) return;
  for (int y = 0; y < image.height(); y++)
    for (int x = 0; x < image.width(); x++)
      if (t.edges[0].at(x, y) >= 0 && t.edges[1].at(x, y) >= 0 && t.edges[2].at(x, y) >= 0)
        image(x, y) = color;
}

}  // namespace rasterlab

// A right answer written differently: squares of pixels are cut in four until all of one is outside
// an edge, or it is a pixel.
#include "common/triangles/fill_edge_functions.h"

#include "common/triangles/edge_function.h"

#include <algorithm>
#include <cstdint>

namespace rasterlab {
namespace {

void fill(Image<Rgb8>& image, const TriangleEdges& triangle, int left, int top, int size,
          const Rgb8& color) {
  if (left >= image.width() || top >= image.height()) return;
  const int right = left + size - 1, bottom = top + size - 1;
  for (const EdgeFunction& edge : triangle.edges) {
    const std::int64_t most = std::max(
        {edge.at(left, top), edge.at(right, top), edge.at(left, bottom), edge.at(right, bottom)});
    if (most < edge.threshold()) return;
  }
  if (size == 1) {
    image(left, top) = color;
    return;
  }
  const int half = size / 2;
  fill(image, triangle, left, top, half, color);
  fill(image, triangle, left + half, top, half, color);
  fill(image, triangle, left, top + half, half, color);
  fill(image, triangle, left + half, top + half, half, color);
}

}  // namespace

void fill_edge_functions(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  const TriangleEdges triangle = make_edges(snap(corners));
  int size = 1;
  while (size < std::max(image.width(), image.height())) size *= 2;
  if (triangle.twice_area != 0) fill(image, triangle, 0, 0, size, color);
}

}  // namespace rasterlab

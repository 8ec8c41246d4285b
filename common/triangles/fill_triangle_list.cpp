#include "common/triangles/fill_triangle_list.h"

#include "common/lines/avx512.h"
#include "common/triangles/fill_spans.h"
#include "common/triangles/fill_triangle_list_avx512.h"

namespace rasterlab {
namespace {

DrawnTriangles fill_one_by_one(Image<Rgb8>& image, std::span<const Corners> triangles,
                               const Rgb8& color) {
  DrawnTriangles drawn;
  for (const Corners& corners : triangles) drawn.add(fill_spans(image, corners, color));
  return drawn;
}

}  // namespace

const std::vector<TriangleListWay>& triangle_list_ways() {
  static const std::vector<TriangleListWay> ways = [] {
    std::vector<TriangleListWay> possible = {{"one by one", &fill_one_by_one}};
    if (has_avx512()) possible.push_back({"avx512", &fill_triangle_list_avx512});
    return possible;
  }();
  return ways;
}

DrawnTriangles fill_triangle_list(Image<Rgb8>& image, std::span<const Corners> triangles,
                                  const Rgb8& color) {
  return triangle_list_ways().back().fill(image, triangles, color);
}

}  // namespace rasterlab

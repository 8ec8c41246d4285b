#include "common/triangles/fill_triangle_list.h"

#include "common/lines/avx512.h"
#include "common/triangles/fill_spans.h"
#include "common/triangles/fill_triangle_list_avx512.h"

#include <algorithm>
#include <cstddef>

namespace rasterlab {
namespace {

DrawnTriangles fill_one_by_one(Image<Rgb8>& image, std::span<const Corners> triangles,
                               const Rgb8& color) {
  DrawnTriangles drawn;
  for (const Corners& corners : triangles) drawn.add(fill_spans(image, corners, color));
  return drawn;
}

/// Whether triangles are so small that eight at a time are quicker than one by one: by the boxes
/// around the first of them.
bool are_small(std::span<const Corners> triangles) {
  constexpr double largest = 256;  // pixels
  const std::span<const Corners> some =
      triangles.first(std::min<std::size_t>(triangles.size(), 64));
  double pixels = 0;
  for (const auto& [a, b, c] : some)
    pixels += (a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c)).prod();
  return pixels <= largest * static_cast<double>(some.size());
}

DrawnTriangles fill_with_avx512(Image<Rgb8>& image, std::span<const Corners> triangles,
                                const Rgb8& color) {
  return are_small(triangles) ? fill_triangle_list_avx512(image, triangles, color)
                              : fill_one_by_one(image, triangles, color);
}

}  // namespace

const std::vector<TriangleListWay>& triangle_list_ways() {
  static const std::vector<TriangleListWay> ways = [] {
    std::vector<TriangleListWay> possible = {{"one by one", &fill_one_by_one}};
    if (has_avx512()) possible.push_back({"avx512", &fill_with_avx512});
    return possible;
  }();
  return ways;
}

DrawnTriangles fill_triangle_list(Image<Rgb8>& image, std::span<const Corners> triangles,
                                  const Rgb8& color) {
  return triangle_list_ways().back().fill(image, triangles, color);
}

}  // namespace rasterlab

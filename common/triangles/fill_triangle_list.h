// Many triangles of one colour, quicker than one by one: given, for who has lists of them.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterlab {

/// What was drawn of several triangles.
struct DrawnTriangles {
  std::int64_t pixels = 0;  ///< inside the image; one that several triangles share counts for each
  std::int64_t triangles = 0;  ///< that have such pixels

  void add(std::int64_t pixels_of_a_triangle) {
    pixels += pixels_of_a_triangle;
    triangles += pixels_of_a_triangle > 0 ? 1 : 0;
  }

  friend bool operator==(const DrawnTriangles&, const DrawnTriangles&) = default;
};

/// Draws what fill_spans() draws of each triangle. Throws CheckError for a corner beyond ±2^30
/// pixels or a coordinate that is not a number; the image is then drawn in part. Triangles may
/// overlap, lie anywhere and have no area. Cost: the rows and pixels inside the image.
DrawnTriangles fill_triangle_list(Image<Rgb8>& image, std::span<const Corners> triangles,
                                  const Rgb8& color);

/// A way to do what fill_triangle_list() does.
struct TriangleListWay {
  const char* name;
  DrawnTriangles (*fill)(Image<Rgb8>& image, std::span<const Corners> triangles, const Rgb8& color);
};

/// The ways that this processor can go, the plain one first; fill_triangle_list() takes the last.
/// All draw the same: for tests and benchmarks.
const std::vector<TriangleListWay>& triangle_list_ways();

}  // namespace rasterlab

// The last rung of exercise 02.4 made quick: given, for stages and benchmarks.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

#include <cstdint>
#include <vector>

namespace rasterlab {

/// Draws the pixels of fill_edge_functions(), exactly those, row by row straight into the image,
/// and returns how many they are. Corners to ±2^30 pixels; throws CheckError beyond, or for a
/// coordinate that is not a number. Cost: the rows and pixels inside the image.
std::int64_t fill_spans(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

/// A way to do what fill_spans() does.
struct SpanFill {
  const char* name;
  std::int64_t (*fill)(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);
};

/// The ways that this processor can go, the plain one first; fill_spans() takes the last. All draw
/// the same: for tests and benchmarks.
const std::vector<SpanFill>& span_fills();

}  // namespace rasterlab

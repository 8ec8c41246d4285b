// Many segments of one colour, quicker than one by one: given, for stages and benchmarks.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lines/draw_line_runs.h"
#include "common/lines/segment.h"

#include <span>
#include <vector>

namespace rasterlab {

/// What draw_line_runs() draws of each segment. Throws CheckError for a coordinate beyond ±2^30;
/// the image is then drawn in part. Cost: the segments' runs, and one pass over the image when they
/// have half as many pixels as it has.
DrawnLines draw_line_list(Image<Rgb8>& image, std::span<const Segment> segments, const Rgb8& color);

/// A way to do what draw_line_list() does.
struct LineListWay {
  const char* name;
  DrawnLines (*draw)(Image<Rgb8>& image, std::span<const Segment> segments, const Rgb8& color);
};

/// The ways that this processor can go, the plain one first; draw_line_list() takes the last. All
/// draw the same: for tests and benchmarks.
const std::vector<LineListWay>& line_list_ways();

}  // namespace rasterlab

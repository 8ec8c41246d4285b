// What is wrong with a way to draw lines, in numbers.
#pragma once

#include "common/lines/line_discrete.h"
#include "common/lines/line_ladder.h"
#include "common/lines/segment.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterlab {

/// Faults of a line against the exact segment; of many lines, the largest distance and the sums of
/// the rest.
struct LineFaults {
  double distance =
      0;  ///< from a pixel to the ideal segment, along the minor axis; right is at most 0.5
  std::int64_t gaps =
      0;  ///< neighbours in the sequence that touch neither at a side nor at a corner
  std::int64_t missing_ends = 0;  ///< ends that are not among the pixels
  std::int64_t doubled = 0;       ///< pixels beyond the first in the same place
  std::int64_t changed_by_swap =
      0;  ///< pixels drawn from p0 to p1 or from p1 to p0, but not both: no fault by itself

  friend bool operator==(const LineFaults&, const LineFaults&) = default;
};

/// The faults of what `line` draws between p0 and p1. Distances are quotients of exact integers.
LineFaults line_faults(LineDiscrete (*line)(const Point&, const Point&), const Segment& segment);
LineFaults line_faults(LineDiscrete (*line)(const Point&, const Point&),
                       const std::vector<Segment>& segments);

/// The segments from (0, 0) to every pixel within ±20: 1681 of all octants, with many ties.
std::vector<Segment> short_segments();

/// `count` segments with ends anywhere in ±`reach`, the same at every call.
std::vector<Segment> random_segments(int count, int reach);

/// One line per rung of the ladder with its faults on all short segments, on segments of up to 1000
/// pixels and on segments of up to 100 000.
std::string line_fault_table();

}  // namespace rasterlab

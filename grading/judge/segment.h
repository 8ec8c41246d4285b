// Whether a sequence of pixels is a right answer for a discrete segment, in exact integers.
#pragma once

#include <string>
#include <vector>

namespace rasterlab::grading {

/// Empty when the pixels (x, y, x, y, …) are a segment between the ends (x0, y0, x1, y1): it starts
/// and ends there, steps by one along the major axis with no gap and no pixel twice, and no pixel
/// is further than ½ from the ideal segment along the minor axis. Else what is broken first.
std::string segment_fault(const std::vector<double>& pixels, const std::vector<double>& ends);

/// The share of the columns (rows of a steep segment) that hold one pixel and that one within ½.
double segment_share(const std::vector<double>& pixels, const std::vector<double>& ends);

}  // namespace rasterlab::grading

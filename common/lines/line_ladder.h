// The rungs of exercise 01.5, from the first attempt to the last.
#pragma once

#include "common/lines/line_discrete.h"

#include <array>

namespace rasterlab {

/// A way to choose the pixels of a segment.
struct LineRung {
  const char* name;
  LineDiscrete (*line)(const Point& p0, const Point& p1);
  const char* known_fault;
};

extern const std::array<LineRung, 7> line_ladder;

}  // namespace rasterlab

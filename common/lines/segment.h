// A segment by its ends.
#pragma once

#include "common/lines/line_discrete.h"

namespace rasterlab {

struct Segment {
  Point p0;
  Point p1;
};

}  // namespace rasterlab

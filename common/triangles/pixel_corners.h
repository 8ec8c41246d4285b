// Corners as courses A and B have them: whole pixels.
#pragma once

#include "common/lines/line_discrete.h"
#include "common/triangles/fixed_point.h"

#include <array>
#include <cmath>

namespace rasterlab {

/// The pixels that the corners fall into. Throws CheckError for a corner beyond ±2^30 or not a
/// number.
inline std::array<Point, 3> pixel_corners(const Corners& corners) {
  if (!within(corners, max_wide_coordinate)) throw_beyond(max_wide_coordinate);
  std::array<Point, 3> pixels;
  for (std::size_t i = 0; i < 3; ++i) {
    pixels[i] = {static_cast<int>(std::floor(corners[i].x())),
                 static_cast<int>(std::floor(corners[i].y()))};
  }
  return pixels;
}

}  // namespace rasterlab

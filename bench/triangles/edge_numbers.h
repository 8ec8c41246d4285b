// In what numbers, and from which point on, edge functions can be computed.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// A grid of cells × cells squares of two triangles each, its vertices jittered.
struct Grid {
  int place;  ///< its first pixel is (place, place)
  int cells;
  int cell_pixels;  ///< a square's side

  int side() const { return cells * cell_pixels; }
};

/// Coverage of the grid's triangles by edge functions in float, double and 64-bit integers, each
/// computed from the window's origin, from a vertex, or from the corner of a tile.
TimedLadder edge_number_ladder(const Grid& grid);

}  // namespace rasterlab::bench

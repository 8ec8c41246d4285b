// Exercise 04.9's ladder, measured.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// A level floor that goes on far behind the eye and `extent` to all sides of it, cut into uneven
/// triangles, clipped by each rung.
TimedLadder clipping_ladder(double extent);

}  // namespace rasterlab::bench

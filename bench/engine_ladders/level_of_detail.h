// How coarse a mesh may be.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// A bumpy sphere of 82 000 triangles in a picture of `pixels` × `pixels`, and the same decimated.
TimedLadder level_of_detail_ladder(int pixels);

}  // namespace rasterlab::bench

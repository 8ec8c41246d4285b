// How attributes can be interpolated in perspective.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Texture coordinates of triangles whose corners' w are up to 1 : w_ratio: planes from the
/// picture's origin, from a tile's, or weights from exact integers; each with a division, an
/// estimate of the reciprocal, and one of Newton's steps.
TimedLadder attribute_ladder(double w_ratio);

/// The same coordinates divided at every pixel, or in affine runs.
TimedLadder affine_run_ladder(double w_ratio);

}  // namespace rasterlab::bench

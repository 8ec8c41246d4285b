// Exercise 06.4's ladder, measured.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

enum class TextureView { near_by, far_off, grazing };

/// A picture of a textured plane by each filter: against the same filter in quads, and against
/// what a pixel sees of the plane, averaged over its area.
TimedLadder filter_ladder_of(TextureView view);

}  // namespace rasterlab::bench

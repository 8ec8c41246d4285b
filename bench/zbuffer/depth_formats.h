// In what form a depth can be stored.
#pragma once

#include "bench/support/ladder.h"

namespace rasterlab::bench {

/// Pairs of points over five decades of distance, one `apart` times its distance behind the other,
/// stored in every form.
TimedLadder depth_format_ladder(double apart);

}  // namespace rasterlab::bench

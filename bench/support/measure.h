// Times, through Google Benchmark.
#pragma once

#include "bench/support/ladder.h"

#include <vector>

namespace rasterlab::bench {

/// How long and how often to measure.
struct Effort {
  int repetitions = 15;
  double seconds = 0.05;  ///< at least, for each repetition
};

/// Nanoseconds per unit of work of each rung, one sample per repetition: of the processor's time of
/// this thread, which other programs disturb less than the clock's. Rungs take turns in random
/// order, so what slows the machine for a while slows all of them.
std::vector<std::vector<double>> measure(const TimedLadder& ladder, const Effort& effort);

}  // namespace rasterlab::bench

// Threads and the cores they stay on.
#pragma once

#include <vector>

namespace rasterlab::bench {

/// Of this process.
std::vector<int> thread_ids();

/// Keeps a thread on a core (0: the calling thread).
void pin(int thread, int core);

/// The most memory this process has had, in MB.
double peak_memory();

}  // namespace rasterlab::bench

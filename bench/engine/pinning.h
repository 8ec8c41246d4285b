// Threads and the cores they stay on.
#pragma once

#include <vector>

namespace rasterlab::bench {

/// Of this process.
std::vector<int> thread_ids();

/// How many cores this process was given.
int core_count();

/// Keeps a thread (0: the calling one) on one of the cores this process was given, the nth.
void pin(int thread, int nth);

/// The most memory this process has had, in MB.
double peak_memory();

}  // namespace rasterlab::bench

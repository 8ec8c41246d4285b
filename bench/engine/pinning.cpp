#include "bench/engine/pinning.h"

#include <filesystem>
#include <string>

#include <sched.h>
#include <sys/resource.h>

namespace rasterlab::bench {

std::vector<int> thread_ids() {
  std::vector<int> ids;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    ids.push_back(std::stoi(entry.path().filename().string()));
  }
  return ids;
}

namespace {

/// As they were before anything was pinned: asked for when the program starts.
const std::vector<int> cores = [] {
  cpu_set_t allowed;
  sched_getaffinity(0, sizeof(allowed), &allowed);
  std::vector<int> list;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &allowed)) list.push_back(core);
  }
  return list;
}();

}  // namespace

int core_count() {
  return static_cast<int>(cores.size());
}

void pin(int thread, int nth) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(cores[static_cast<std::size_t>(nth) % cores.size()], &set);
  sched_setaffinity(thread, sizeof(set), &set);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace rasterlab::bench

#include "common/engine/thread_team.h"

#include <utility>

namespace rasterlab {

#if defined(__linux__)
StayOnCore::StayOnCore(int number) {
  sched_getaffinity(0, sizeof(allowed_), &allowed_);
  int seen = 0;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &allowed_) || seen++ != number % CPU_COUNT(&allowed_)) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    sched_setaffinity(0, sizeof(one), &one);
  }
}
#endif

namespace {

/// Waits until `value` isn't `old`: awake for about as long as it takes to put a thread to sleep
/// and wake it, as jobs follow each other closely in a draw call; then asleep.
void wait_while(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int times = 0; times < 256; ++times) {
    if (value != old) return;
    std::this_thread::yield();
  }
  value.wait(old);
}

bool is_open(std::uint32_t round) {
  return round % 2 == 1;
}

}  // namespace

ThreadTeam::ThreadTeam(int size, bool pinned) : pinned_(pinned) {
  for (int member = 1; member < size; ++member) {
    others_.emplace_back([this, member] { work_until_end(member); });
  }
}

ThreadTeam::~ThreadTeam() {
  ends_ = true;
  round_ += 2;
  round_.notify_all();
  for (std::thread& other : others_) other.join();
}

void ThreadTeam::run_on_all(const Job& job) {
  job_ = job;
  ++round_;
  round_.notify_all();
  run_guarded(0);
  ++round_;
  for (std::uint32_t joined = joined_; joined != 0; joined = joined_) wait_while(joined_, joined);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void ThreadTeam::run_guarded(int member) {
  try {
    job_.run(job_.work, member);
  } catch (...) {
    const std::lock_guard lock(error_mutex_);
    if (!error_) error_ = std::current_exception();
  }
}

void ThreadTeam::work_until_end(int member) {
  std::optional<StayOnCore> on_core;
  if (pinned_) on_core.emplace(member);
  std::uint32_t last = 0;
  while (!ends_) {
    const std::uint32_t round = round_;
    if (round == last || !is_open(round)) {
      wait_while(round_, round);
      continue;
    }
    last = round;
    // Joined before it is looked whether the round is open still: who closes it does the opposite,
    // so that either this sees it closed or it is waited for.
    ++joined_;
    if (round_ == round) run_guarded(member);
    --joined_;
    joined_.notify_all();
  }
}

}  // namespace rasterlab

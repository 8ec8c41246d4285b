// Threads that work items off together.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace rasterlab {

/// Keeps the thread that makes it on one core, of those it may use, as long as it lives.
class StayOnCore {
 public:
#if defined(__linux__)
  /// The core is the `number`th, modulo how many there are.
  explicit StayOnCore(int number);
  ~StayOnCore() {
    sched_setaffinity(0, sizeof(allowed_), &allowed_);
  }
  StayOnCore(const StayOnCore&) = delete;
  StayOnCore& operator=(const StayOnCore&) = delete;

 private:
  cpu_set_t allowed_;
#else
  explicit StayOnCore(int) {}
#endif
};

/// The calling thread and others, which wait for work in between.
///
/// What is written before for_each() is seen in it, and what is written in it is seen after: by
/// atomics alone, so that the thread sanitizer can follow, which it can't into a library that was
/// built without it.
class ThreadTeam {
 public:
  /// `size` counts the calling thread and is at least 1. `pinned`: the others stay on one core
  /// each.
  explicit ThreadTeam(int size, bool pinned = false);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls `work(item, member)` for items 0 … count − 1 in no order. `member` is 0 … size() − 1 and
  /// has one caller at a time. From one thread at a time. What `work` throws, the first of it, is
  /// thrown when all have stopped.
  template <class Work>
  void for_each(int count, const Work& work) {
    next_.store(0, std::memory_order_relaxed);
    const auto work_off = [this, count, &work](int member) {
      for (int item = next_++; item < count; item = next_++) work(item, member);
    };
    if (others_.empty() || count <= 1) return work_off(0);
    run_on_all({&work_off, [](const void* to_do, int member) {
                  (*static_cast<decltype(&work_off)>(to_do))(member);
                }});
  }

  /// For the calling thread of a pinned team, to hold during what it calls for_each() in: to come
  /// and go costs system calls.
  void stay(std::optional<StayOnCore>& on_core) const {
    if (pinned_) on_core.emplace(0);
  }

 private:
  struct Job {
    const void* work;
    void (*run)(const void* work, int member);
  };

  void run_on_all(const Job& job);
  void run_guarded(int member);
  void work_until_end(int member);

  bool pinned_;
  Job job_{};
  std::mutex error_mutex_;
  std::exception_ptr error_;
  // Each on a cache line of its own: others wait for one while the next is counted.
  alignas(64) std::atomic<int> next_ = 0;  ///< item
  /// Odd while there is a job to join. One that comes late needn't be waited for.
  alignas(64) std::atomic<std::uint32_t> round_ = 0;
  alignas(64) std::atomic<std::uint32_t> joined_ = 0;  ///< members besides the calling thread
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> others_;
};

}  // namespace rasterlab

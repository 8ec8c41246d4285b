// Threads that work items off together: each item once, and nothing lost between the threads.
#include "common/engine/thread_team.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterlab {

namespace {

// Rounds follow each other at once, so that threads come late to many of them; what is counted is
// plain, so that the thread sanitizer sees any round that isn't handed over.
TEST(engine_thread_team, does_each_item_once_in_every_round) {
  for (const int size : {1, 2, 3, 8}) {
    ThreadTeam team(size);
    std::vector<int> done(37);
    std::vector<int> by_member(static_cast<std::size_t>(team.size()));
    constexpr int rounds = 500;
    for (int round = 0; round < rounds; ++round) {
      team.for_each(static_cast<int>(done.size()), [&](int item, int member) {
        ++done[static_cast<std::size_t>(item)];
        ++by_member[static_cast<std::size_t>(member)];
      });
      ASSERT_EQ(std::count(done.begin(), done.end(), round + 1), 37) << size << " threads";
    }
    int total = 0;
    for (const int count : by_member) total += count;
    EXPECT_EQ(total, rounds * 37);
  }
}

TEST(engine_thread_team, has_nothing_to_do_without_items) {
  ThreadTeam team(2);
  team.for_each(0, [](int, int) { FAIL(); });
}

TEST(engine_thread_team, passes_on_what_work_throws_and_goes_on) {
  ThreadTeam team(3);
  for (int bad = 0; bad < 20; ++bad) {
    EXPECT_THROW(team.for_each(20,
                               [&](int item, int) {
                                 if (item == bad) throw std::runtime_error("bad item");
                               }),
                 std::runtime_error);
  }
  std::atomic<int> count = 0;
  team.for_each(20, [&](int, int) { ++count; });
  EXPECT_EQ(count, 20);
}

}  // namespace

}  // namespace rasterlab

// What a run of a stage does with its results.
#include "common/stage/run.h"

#include "common/image/bytes.h"
#include "common/stage/guard.h"

#include "tests/support/scratch.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

Run run_into(const std::filesystem::path& out) {
  return Run({.out = out,
              .exercise = {},
              .algorithm = {},
              .size = {},
              .statistics = false,
              .quiet = true});
}

TEST(cli_run, a_single_file_is_written_when_the_run_ends) {
  const ScratchFolder folder;
  write_file(folder / "one.png", "what was there");
  rasterlab::Run run = run_into(folder / "one.png");
  run.picture("first", Image<std::uint8_t>(2, 2));
  EXPECT_EQ(read_file(folder / "one.png"), "what was there");
  run.finish();
  EXPECT_EQ(read_file(folder / "one.png").substr(1, 3), "PNG");
}

TEST(cli_run, several_results_for_one_file_leave_it_as_it_was) {
  const ScratchFolder folder;
  write_file(folder / "one.png", "what was there");
  {
    rasterlab::Run run = run_into(folder / "one.png");
    run.picture("first", Image<std::uint8_t>(2, 2));
    EXPECT_THROW(run.picture("second", Image<std::uint8_t>(2, 2)), UsageError);
    EXPECT_THROW(run.file("third.txt", [](const auto&) {}), UsageError);
  }
  EXPECT_EQ(read_file(folder / "one.png"), "what was there");
}

TEST(cli_run, a_folder_takes_any_number) {
  const ScratchFolder folder;
  rasterlab::Run run = run_into(folder / "results");
  run.picture("first", Image<std::uint8_t>(2, 2));
  run.picture("second", Image<std::uint8_t>(2, 2));
  run.finish();
  EXPECT_TRUE(std::filesystem::exists(folder / "results/first.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "results/second.png"));
}

}  // namespace
}  // namespace rasterlab

// ./lab, what needs no build: it runs in a folder that holds nothing else.
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::cli {
namespace {

namespace fs = std::filesystem;

class cli_lab : public testing::Test {
 protected:
  const ScratchFolder scratch_;

  void SetUp() override {
    fs::copy_file(source_folder() / "lab", scratch_ / "lab");
    fs::create_directories(scratch_ / "build/release");
  }

  ProcessResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), scratch_ / "lab");
    return run_process(arguments);
  }
};

TEST_F(cli_lab, to_ask_for_help_does_nothing_else) {
  for (const char* command : {"demo", "test", "stage", "bench", "clean"}) {
    for (const char* flag : {"--help", "-h"}) {
      const ProcessResult result = run({command, flag});
      EXPECT_EQ(result.exit_status, 0) << command;
      EXPECT_THAT(result.out, testing::StartsWith("usage: ./lab")) << command;
    }
  }
  EXPECT_TRUE(fs::exists(scratch_ / "build/release"));
}

TEST_F(cli_lab, refuses_what_it_does_not_know) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"fly"},
                                                  {"demo", "now"},
                                                  {"clean", "all"},
                                                  {"test", "--fly", "1"},
                                                  {"stage"},
                                                  {"stage", "08"},
                                                  {"bench", "--fly"},
                                                  {"stress"}}) {
    const ProcessResult result = run(command);
    EXPECT_EQ(result.exit_status, 2) << command.front();
    EXPECT_THAT(result.err, testing::StartsWith("lab: ")) << command.front();
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
  EXPECT_TRUE(fs::exists(scratch_ / "build/release"));
}

TEST_F(cli_lab, clean_removes_what_was_built) {
  EXPECT_EQ(run({"clean"}).exit_status, 0);
  EXPECT_FALSE(fs::exists(scratch_ / "build"));
}

}  // namespace
}  // namespace rasterlab::cli

// The programs that measure ladders: their command lines, what they write, and the page made of it.
#include "common/image/bytes.h"

#include "tests/cli/command_line.h"
#include "tests/support/places.h"

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab::cli {
namespace {

namespace fs = std::filesystem;

/// Those that are built: they need Google Benchmark.
std::vector<std::string> benches() {
  std::vector<std::string> found;
  for (const std::string& stage : stages()) {
    if (fs::exists(program("bench_" + stage))) found.push_back("bench_" + stage);
  }
  return found;
}

class cli_bench : public testing::Test {
 protected:
  const ScratchFolder scratch_;

  void SetUp() override {
    if (benches().empty()) GTEST_SKIP() << "Google Benchmark was not found";
  }

  ProcessResult make_page(const fs::path& data) {
    return run_process({"python3", source_folder() / "tools/make_bench_page.py", "--data", data},
                       {.folder = scratch_.path()});
  }
};

TEST_F(cli_bench, help_names_every_flag) {
  for (const std::string& bench : benches()) {
    const ProcessResult result = run(bench, {"--help"}, scratch_.path());
    EXPECT_EQ(result.exit_status, 0) << bench;
    EXPECT_EQ(result.err, "") << bench;
    for (const char* flag : {"--help", "--quick", "--out", "--ladder"})
      EXPECT_THAT(result.out, testing::HasSubstr(flag)) << bench;
  }
}

TEST_F(cli_bench, bad_usage_and_bad_places_are_refused) {
  for (const std::string& bench : benches()) {
    expect_refusal(bench, {"--fast"}, 2);
    expect_refusal(bench, {"stray"}, 2);
    expect_refusal(bench, {"--out"}, 2);
    expect_refusal(bench, {"--quick", "--out", "/proc/rasterlab"}, 1);
  }
  expect_refusal(benches().back(), {"--quick", "--ladder", "none is called so"}, 1);
}

TEST_F(cli_bench, measures_every_rung_and_the_page_shows_each_ladder) {
  if (!fs::exists(program("bench_03_zbuffer"))) GTEST_SKIP() << "stage 03 is not there";
  const ProcessResult result = run("bench_03_zbuffer", {"--quick", "--out", "m"}, scratch_.path());
  ASSERT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, testing::HasSubstr("wrote m/bench_03_zbuffer.json\n"));
  const nlohmann::json rungs =
      nlohmann::json::parse(files_in(scratch_ / "m").at("bench_03_zbuffer.json"));
  ASSERT_GE(rungs.size(), 6U);
  std::set<std::string> ladders;
  for (const nlohmann::json& rung : rungs) {
    ladders.insert(rung.at("ladder"));
    EXPECT_EQ(rung.at("stage"), "03");
    EXPECT_GE(rung.at("repetitions"), 7);
    EXPECT_GT(rung.at("ns_median"), 0);
    EXPECT_GE(rung.at("ns_median"), rung.at("ns_min"));
    EXPECT_GE(rung.at("errors").at(rung.at("plotted_error").get<std::string>()), 0);
    EXPECT_THAT(result.out, testing::HasSubstr("  " + rung.at("rung").get<std::string>() + " "));
  }
  const ProcessResult page = make_page("m");
  if (page.err.find("gnuplot is not installed") != std::string::npos) GTEST_SKIP() << page.err;
  ASSERT_EQ(page.exit_status, 0) << page.err;
  const std::string text = files_in(scratch_ / "m").at("index.html");
  for (const std::string& ladder : ladders) EXPECT_THAT(text, testing::HasSubstr(ladder));
  EXPECT_THAT(text, testing::HasSubstr("<svg"));
}

TEST_F(cli_bench, the_page_refuses_what_are_no_measurements) {
  fs::create_directories(scratch_ / "empty");
  const ProcessResult nothing = make_page("empty");
  EXPECT_EQ(nothing.exit_status, 1);
  EXPECT_THAT(nothing.err, testing::MatchesRegex("make_bench_page: [^\n]+\n"));
  for (const char* content : {"no JSON", "[1]", "[{\"stage\": \"01\"}]"}) {
    write_file(scratch_ / "empty/bench_01_lines.json", content);
    const ProcessResult broken = make_page("empty");
    EXPECT_EQ(broken.exit_status, 1) << content;
    EXPECT_THAT(broken.err, testing::MatchesRegex("make_bench_page: [^\n]+\n")) << content;
  }
}

}  // namespace
}  // namespace rasterlab::cli

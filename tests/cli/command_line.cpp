#include "tests/cli/command_line.h"

#include "common/image/files.h"

#include "tests/support/places.h"

#include <algorithm>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::cli {

namespace fs = std::filesystem;

std::vector<std::string> stages() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(source_folder())) {
    if (fs::exists(entry.path() / "exercises.json")) found.push_back(entry.path().filename());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::string> viewer_stages() {
  std::vector<std::string> found = stages();
  std::erase_if(found, [](const std::string& stage) { return stage < "04"; });
  return found;
}

ProcessResult run(const std::string& name, const std::vector<std::string>& arguments,
                  const fs::path& folder) {
  std::vector<std::string> command{program(name)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, {.folder = folder});
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder)] = read_file(entry.path());
  }
  return files;
}

void expect_one_line(const std::string& name, const ProcessResult& result) {
  constexpr std::size_t enough_to_see = 500;
  EXPECT_THAT(result.err.substr(0, enough_to_see), testing::MatchesRegex(name + ": [^\n]+\n"));
}

void expect_refusal(const std::string& name, const std::vector<std::string>& arguments,
                    int status) {
  const ScratchFolder here;
  SCOPED_TRACE(name + " " + testing::PrintToString(arguments));
  const ProcessResult result = run(name, arguments, here.path());
  EXPECT_EQ(result.exit_status, status);
  expect_one_line(name, result);
  EXPECT_EQ(result.out, "");
  for (const auto& [file, content] : files_in(here.path()))
    ADD_FAILURE() << "left behind: " << file;
}

std::vector<BadFile> bad_files(const fs::path& folder, const std::string& extension) {
  const auto path = [&](const std::string& name) { return folder / (name + extension); };
  fs::create_directories(path("folder"));
  std::ofstream(path("empty")).flush();
  std::mt19937 random(7);
  std::ofstream noise(path("noise"), std::ios::binary);
  for (int i = 0; i < 4000; ++i) noise.put(static_cast<char>(random() & 0xFFU));
  return {{"missing", path("missing")},
          {"a folder", path("folder")},
          {"empty", path("empty")},
          {"noise", path("noise")}};
}

}  // namespace rasterlab::cli

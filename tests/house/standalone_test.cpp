// A stage never needs a later one: each builds and runs in a tree from which the folders of later
// stages and their topics in common have been removed, as a hand-out removes them.
#include "tests/house/repository.h"
#include "tests/support/places.h"
#include "tests/support/process.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

std::string topic_of(const std::string& stage) {
  return stage.substr(3);
}

/// Makes `target` the same as `source`: files that differ are copied with their times, others left
/// alone, so that a build of the copy redoes only what changed.
void mirror(const fs::path& source, const fs::path& target) {
  std::set<fs::path> wanted;
  fs::create_directories(target);
  for (const auto& entry : fs::directory_iterator(source)) {
    const fs::path name = entry.path().filename();
    wanted.insert(name);
    if (entry.is_directory()) {
      mirror(entry.path(), target / name);
    } else if (!fs::exists(target / name) ||
               fs::last_write_time(target / name) != entry.last_write_time()) {
      fs::copy_file(entry.path(), target / name, fs::copy_options::overwrite_existing);
      fs::last_write_time(target / name, entry.last_write_time());
    }
  }
  std::vector<fs::path> stale;
  for (const auto& entry : fs::directory_iterator(target)) {
    if (wanted.count(entry.path().filename()) == 0) stale.push_back(entry.path());
  }
  for (const fs::path& path : stale) fs::remove_all(path);
}

/// What a hand-out of all stages holds, without tests and benchmarks.
void copy_tree(const fs::path& tree) {
  for (const char* folder : {"cmake", "common", "data"}) mirror(root() / folder, tree / folder);
  for (const std::string& stage : stages()) mirror(root() / stage, tree / stage);
  fs::copy_file(root() / "CMakeLists.txt", tree / "CMakeLists.txt",
                fs::copy_options::overwrite_existing);
}

void remove_stage(const fs::path& tree, const std::string& stage) {
  fs::remove_all(tree / stage);
  fs::remove_all(tree / "common" / topic_of(stage));
  if (topic_of(stage) == "projection")
    fs::remove_all(tree / "common/viewer");  // it comes with stage 04
}

ProcessResult succeed(const std::vector<std::string>& command, const fs::path& folder) {
  ProcessResult result =
      run_process(command, {.folder = folder, .limit = std::chrono::seconds(1500)});
  EXPECT_EQ(result.exit_status, 0) << testing::PrintToString(command) << "\n"
                                   << result.out << result.err;
  return result;
}

TEST(house_standalone, every_stage_builds_and_runs_without_the_later_ones) {
  const fs::path place = binary_folder() / "standalone";
  const fs::path tree = place / "tree";
  // Compiled as ./lab compiles, and from a folder that lies alike in its tree: the compiler cache,
  // which looks at every header again, then has what is the same there as here.
  const fs::path build = tree / "build/release";
  copy_tree(tree);
  succeed({"cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
           "-DRASTERLAB_TESTS=OFF", "-DRASTERLAB_BENCHMARKS=OFF"},
          place);
  std::vector<std::string> left = stages();
  while (!left.empty() && !HasFailure()) {
    const std::string stage = left.back();
    SCOPED_TRACE(stage);
    succeed({"cmake", "--build", build, "--target", stage}, place);
    const std::string executable = build / "bin" / stage;
    EXPECT_NE(succeed({executable, "--list"}, place).out, "");
    const std::string first = exercises(stage).at(0).at("id");
    succeed({executable, "--exercise", first, "--size", "64x48", "--out", place / "out"}, place);
    remove_stage(tree, stage);
    left.pop_back();
  }
}

}  // namespace
}  // namespace rasterlab::house

// The reference pictures: each has a recipe, each recipe a picture, and the recipe still makes it.
#include "common/image/files.h"

#include "tests/house/repository.h"
#include "tests/support/expect_image.h"
#include "tests/support/pattern.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

class house_references : public testing::TestWithParam<std::string> {
 protected:
  const fs::path folder_ = root() / GetParam() / "expected";

  nlohmann::json recipes() const {
    return nlohmann::json::parse(read_file(folder_ / "recipes.json")).at("pictures");
  }
};

std::string stage_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(, house_references, testing::ValuesIn(stages()), stage_name);

TEST_P(house_references, each_has_a_recipe_and_each_recipe_a_reference) {
  std::multiset<std::string> described;
  for (const nlohmann::json& recipe : recipes()) {
    described.insert(recipe.at("file").get<std::string>());
    EXPECT_FALSE(recipe.at("why").get<std::string>().empty()) << recipe.at("file");
  }
  std::multiset<std::string> there;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.path().filename() != "recipes.json") there.insert(entry.path().filename());
  }
  EXPECT_EQ(there, described);
}

/// Whether a name is that of one of the references; "05.6_light_*.png" is where one of many is.
bool is_among(const std::string& name, const std::set<std::string>& files) {
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& file) { return matches(name, file); });
}

TEST_P(house_references, every_picture_an_exercise_writes_has_one_or_a_reason_why_not) {
  const nlohmann::json all = nlohmann::json::parse(read_file(folder_ / "recipes.json"));
  std::set<std::string> there;
  for (const nlohmann::json& recipe : all.at("pictures")) there.insert(recipe.at("file"));
  const nlohmann::json reasons = all.value("without_reference", nlohmann::json::object());
  for (const nlohmann::json& exercise : exercises(GetParam())) {
    for (const std::string name : exercise.at("writes")) {
      if (fs::path(name).extension() == ".txt") continue;
      EXPECT_NE(is_among(name, there), reasons.contains(name)) << name;
    }
  }
  for (const auto& [name, reason] : reasons.items()) {
    EXPECT_FALSE(reason.get<std::string>().empty()) << name;
  }
}

/// The words of a recipe's command, its executable's path in place of its name and `out` of OUT.
std::vector<std::string> command_of(const std::string& recipe, const fs::path& out) {
  std::istringstream stream(std::regex_replace(recipe, std::regex("\\bOUT\\b"), out.string()));
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words.at(0) = program(words.at(0));
  return words;
}

TEST_P(house_references, recipes_still_make_them) {
  const ScratchFolder scratch;
  std::map<std::string, fs::path> made;  // by command: pictures of one run are made once
  for (const nlohmann::json& recipe : recipes()) {
    const std::string command = recipe.at("command");
    SCOPED_TRACE(command);
    if (made.count(command) == 0) {
      made[command] = scratch / std::to_string(made.size());
      const ProcessResult result =
          run_process(command_of(command, made[command]), {.folder = root()});
      EXPECT_EQ(result.exit_status, 0) << result.err;
    }
    const std::string file = recipe.at("file");
    ASSERT_TRUE(fs::exists(made[command] / file)) << file << " is not made";
    expect_image_matches(read_any_image(made[command] / file), folder_ / file,
                         {.max_difference = recipe.at("max_difference").get<double>(),
                          .total_pixels = recipe.at("total_pixels").get<std::size_t>()});
  }
}

TEST(house_references_size, all_committed_pictures_and_data_stay_small) {
  std::uintmax_t bytes = 0;
  std::vector<fs::path> folders{root() / "data"};
  for (const std::string& stage : stages()) folders.push_back(root() / stage / "expected");
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) bytes += entry.file_size();
    }
  }
  EXPECT_LE(bytes, 2U << 20U);
}

}  // namespace
}  // namespace rasterlab::house

// Every stage's exercises.json: what it promises is there.
#include "common/image/files.h"

#include "tests/house/repository.h"
#include "tests/support/pattern.h"

#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

/// How many exercises each stage has.
const std::map<std::string, int> exercise_counts{{"01", 11}, {"02", 7}, {"03", 6}, {"04", 10},
                                                 {"05", 8},  {"06", 4}, {"07", 8}};

/// Whether a text has this word, as an identifier.
bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

/// Calls `check(stage, exercise)` for every exercise of every stage.
template <class Check>
void for_each_exercise(const Check& check) {
  for (const std::string& stage : stages()) {
    for (const nlohmann::json& exercise : exercises(stage)) {
      SCOPED_TRACE(exercise.at("id").get<std::string>());
      check(stage, exercise);
    }
  }
}

TEST(house_manifests, stages_name_themselves) {
  for (const std::string& stage : stages()) {
    EXPECT_EQ(nlohmann::json::parse(read_file(root() / stage / "exercises.json")).at("stage"),
              stage);
  }
}

TEST(house_manifests, every_exercise_is_there_in_order) {
  for (const std::string& stage : stages()) {
    const std::string number = stage.substr(0, 2);
    std::vector<std::string> ids;
    for (const nlohmann::json& exercise : exercises(stage)) ids.push_back(exercise.at("id"));
    std::vector<std::string> expected;
    for (int i = 1; i <= exercise_counts.at(number); ++i)
      expected.push_back(number + "." + std::to_string(i));
    EXPECT_EQ(ids, expected) << stage;
  }
}

TEST(house_manifests, entries_are_complete) {
  for_each_exercise([](const std::string&, const nlohmann::json& exercise) {
    for (const char* text : {"title", "file", "function", "source", "description"}) {
      EXPECT_FALSE(exercise.value(text, "").empty()) << text;
    }
    EXPECT_GT(exercise.value("points", 0), 0);
    EXPECT_FALSE(exercise.value("writes", nlohmann::json::array()).empty());
    EXPECT_FALSE(exercise.value("tests", nlohmann::json::array()).empty());
  });
}

/// Whether a header of the folder declares this name. A ladder's rungs share one header.
bool is_declared(const fs::path& folder, const std::string& name) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".h" && has_word(read_file(entry.path()), name)) return true;
  }
  return false;
}

TEST(house_manifests, the_function_is_declared_in_a_header_and_defined_in_the_file) {
  for_each_exercise([](const std::string&, const nlohmann::json& exercise) {
    const fs::path file = root() / exercise.at("file").get<std::string>();
    const std::string function = exercise.at("function");
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(has_word(read_file(file), function)) << function << " in " << file;
    EXPECT_TRUE(is_declared(file.parent_path(), function)) << function << " beside " << file;
  });
}

TEST(house_manifests, compared_pictures_are_among_those_written) {
  for_each_exercise([](const std::string&, const nlohmann::json& exercise) {
    const std::set<std::string> writes = exercise.at("writes").get<std::set<std::string>>();
    for (const nlohmann::json& pair : exercise.value("compare", nlohmann::json::array())) {
      EXPECT_EQ(pair.size(), 2U);
      for (const std::string file : pair) EXPECT_EQ(writes.count(file), 1U) << file;
    }
  });
}

TEST(house_manifests, every_exercise_has_tests_and_every_pattern_finds_some) {
  for_each_exercise([](const std::string& stage, const nlohmann::json& exercise) {
    for (const std::string pattern : exercise.at("tests")) {
      EXPECT_TRUE(some_test_matches(pattern)) << pattern << " in " << stage << "/exercises.json";
    }
  });
}

TEST(house_manifests, patterns_match_as_they_say) {
  EXPECT_TRUE(matches("stage01.draw_line.*", "stage01.draw_line.both_ends"));
  EXPECT_TRUE(matches("stage01.*.both*", "stage01.draw_line.both_ends"));
  EXPECT_TRUE(matches("*", "anything"));
  EXPECT_FALSE(matches("stage01.draw_line.*", "stage01.draw_lines.both_ends"));
  EXPECT_FALSE(matches("stage01.draw_line", "stage01.draw_line.both_ends"));
}

}  // namespace
}  // namespace rasterlab::house

// Command lines, good and bad, of every stage's executable.
#include "common/image/files.h"

#include "tests/cli/command_line.h"
#include "tests/support/pattern.h"
#include "tests/support/places.h"

#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab::cli {
namespace {

namespace fs = std::filesystem;

nlohmann::json exercises(const std::string& stage) {
  const fs::path manifest = source_folder() / stage / "exercises.json";
  return nlohmann::json::parse(read_file(manifest)).at("exercises");
}

class cli_stage : public testing::TestWithParam<std::string> {
 protected:
  const std::string stage_ = GetParam();
  const ScratchFolder scratch_;

  ProcessResult run_here(const std::vector<std::string>& arguments) {
    return run(stage_, arguments, scratch_.path());
  }
};

std::string stage_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(, cli_stage, testing::ValuesIn(stages()), stage_name);

std::vector<std::string> flags_of(const std::string& stage) {
  std::vector<std::string> flags{"--help", "--list",  "--exercise", "--out",
                                 "--size", "--stats", "--quiet"};
  const auto add = [&](std::initializer_list<const char*> more) {
    flags.insert(flags.end(), more.begin(), more.end());
  };
  if (stage != "07_shaders") add({"--algorithm"});  // it has no ladder
  if (stage == "01_lines") add({"--lines", "convert"});
  if (stage == "02_triangles") add({"--triangles", "--coverage"});
  if (stage == "03_zbuffer") add({"--triangles"});
  if (stage >= "04") {
    add({"--mesh", "--scene", "--eye", "--center", "--up", "--fovy", "--near", "--far", "--ortho",
         "--color", "--cull", "--without", "--frames", "--turntable", "--repeat", "--depth",
         "--ids"});
  }
  if (stage >= "05") add({"--light", "--material"});
  if (stage >= "06") add({"--texture", "--filter", "--wrap"});
  if (stage >= "07") add({"--normal-map", "--specular-map", "--shader"});
  return flags;
}

TEST_P(cli_stage, help_names_every_flag) {
  const ProcessResult result = run_here({"--help"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.err, "");
  for (const std::string& flag : flags_of(stage_)) {
    EXPECT_TRUE(std::regex_search(result.out, std::regex("(^|[\\s,])" + flag + "($|[\\s,=])")))
        << flag;
  }
}

TEST_P(cli_stage, list_names_exercises_and_what_they_write) {
  const ProcessResult result = run_here({"--list"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.err, "");
  for (const nlohmann::json& exercise : exercises(stage_)) {
    EXPECT_THAT(result.out, testing::HasSubstr(exercise.at("id").get<std::string>() + "  " +
                                               exercise.at("title").get<std::string>() + "\n"));
    for (const std::string file : exercise.at("writes"))
      EXPECT_THAT(result.out, testing::HasSubstr(" " + file + "\n"));
  }
  EXPECT_THAT(files_in(scratch_.path()), testing::IsEmpty());
}

TEST_P(cli_stage, bad_usage_is_refused) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--fly"},
                                             {"stray"},
                                             {"--exercise"},
                                             {"--exercise", "99.9"},

                                             {"--size"},
                                             {"--size", "large"},
                                             {"--size", "640"},
                                             {"--size", "640x"},
                                             {"--size", "0x48"},
                                             {"--size", "-64x48"},
                                             {"--size", "64x48x2"},
                                             {"--size", "6.4x4"},
                                             {"--size", "99999999999x2"},
                                             {"--size", "99999x99999"},
                                             {"--algorithm", "nonsense"},
                                             {"--out"},
                                             {"--list", "--fly"}}) {
    expect_refusal(stage_, arguments, 2);
  }
}

TEST_P(cli_stage, places_that_cannot_be_written_are_refused) {
  const std::string first = exercises(stage_).at(0).at("id");
  write_file(scratch_ / "file", "in the way");
  for (const std::string& place :
       {std::string("/proc/rasterlab/x"), (scratch_ / "file/x").string()}) {
    const ProcessResult result = run_here({"--out", place});
    EXPECT_EQ(result.exit_status, 1);
    expect_one_line(stage_, result);
    EXPECT_EQ(files_in(scratch_.path()).size(), 1U);
  }
}

/// Whether an exercise asked for alone writes this file: printouts go to standard output.
bool is_written_alone(const std::string& file) {
  return std::regex_match(file, std::regex("[A-Za-z0-9_.-]+")) && !file.ends_with(".txt");
}

/// Whether a file is among those a manifest names, as "05.6_light_*.png".
bool is_promised(const std::set<std::string>& promised, const std::string& file) {
  return std::any_of(promised.begin(), promised.end(),
                     [&](const std::string& pattern) { return matches(pattern, file); });
}

TEST_P(cli_stage, each_exercise_writes_what_its_manifest_says) {
  int number = 0;
  for (const nlohmann::json& exercise : exercises(stage_)) {
    const std::string id = exercise.at("id");
    SCOPED_TRACE(id);
    const fs::path out = scratch_ / ("of_" + std::to_string(number++));
    const ProcessResult result = run_here({"--exercise", id, "--size", "64x48", "--out", out});
    ASSERT_EQ(result.exit_status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::map<std::string, std::string> files = files_in(out);
    const auto promised = exercise.at("writes").get<std::set<std::string>>();
    for (const auto& [file, content] : files) {
      EXPECT_TRUE(is_promised(promised, file)) << file << " is written but not in the manifest";
      EXPECT_FALSE(content.empty()) << file;
      EXPECT_THAT(result.out, testing::HasSubstr("wrote " + (out / file).string() + "\n"));
    }
    for (const std::string& file : promised) {
      EXPECT_TRUE(!is_written_alone(file) || files.count(file) != 0)
          << file << " is in the manifest but not written";
    }
  }
}

TEST_P(cli_stage, quiet_twice_gives_the_same_bytes_and_nothing_else) {
  const std::vector<std::string> arguments{"-q", "--size", "64x48", "--out",
                                           (scratch_ / "out").string()};
  const ProcessResult first = run_here(arguments);
  EXPECT_EQ(first.exit_status, 0);
  EXPECT_EQ(first.out + first.err, "");
  const std::map<std::string, std::string> files = files_in(scratch_.path());
  EXPECT_FALSE(files.empty());
  EXPECT_EQ(run_here(arguments).exit_status, 0);
  const std::map<std::string, std::string> again = files_in(scratch_.path());
  ASSERT_EQ(again.size(), files.size());
  for (const auto& [file, content] : files) {
    if (file.ends_with("backtrace_log.txt")) continue;  // holds addresses
    EXPECT_TRUE(again.at(file) == content) << file << " differs";
  }
}

TEST_P(cli_stage, statistics_are_one_json_object) {
  const std::string id = exercises(stage_).at(0).at("id");
  const ProcessResult result =
      run_here({"--exercise", id, "--stats", "--size", "64x48", "--out", scratch_ / "out"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  const nlohmann::json statistics = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_TRUE(statistics.is_object()) << result.out;
  EXPECT_GE(statistics.at("milliseconds").at(id).get<double>(), 0);
}

TEST_P(cli_stage, every_listed_rung_can_be_chosen) {
  const ProcessResult list = run_here({"--algorithm", "list"});
  if (list.exit_status == 2)
    return;  // a stage without a ladder has no such flag: see bad_usage_is_refused
  const std::regex rung("\n  ([a-z0-9_]+): ");
  int count = 0;
  for (std::sregex_iterator it(list.out.begin(), list.out.end(), rung), end; it != end;
       ++it, ++count) {
    const std::string name = (*it)[1];
    const ProcessResult result =
        run_here({"--algorithm", name, "--size", "64x48", "--out", scratch_ / name});
    EXPECT_EQ(result.exit_status, 0) << name << ": " << result.err;
    EXPECT_FALSE(files_in(scratch_ / name).empty()) << name;
  }
  EXPECT_GE(count, 2) << list.out;
}

class cli_viewer : public cli_stage {};

INSTANTIATE_TEST_SUITE_P(, cli_viewer, testing::ValuesIn(viewer_stages()), stage_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(cli_viewer);

TEST_P(cli_viewer, bad_values_are_refused) {
  std::vector<std::vector<std::string>> bad{{"--eye", "1,2"},
                                            {"--eye", "a,b,c"},
                                            {"--eye", "1,2,3,4"},
                                            {"--eye", "1,2,nan"},
                                            {"--center", ""},
                                            {"--up", "0,0,0"},
                                            {"--fovy", "0"},
                                            {"--fovy", "180"},
                                            {"--fovy", "wide"},
                                            {"--fovy", "nan"},
                                            {"--near", "0"},
                                            {"--near", "-1"},
                                            {"--near", "5", "--far", "2"},
                                            {"--far", "x"},
                                            {"--ortho", "0"},
                                            {"--ortho", "-2"},
                                            {"--color", "1,2"},
                                            {"--color", "red"},
                                            {"--cull", "sideways"},
                                            {"--engine", "warp"},
                                            {"--threads", "-1"},
                                            {"--simd", "mmx"},
                                            {"--engine", "tiled", "--without", ""},
                                            {"--engine", "tiled", "--without", "fog"},
                                            {"--engine", "tiled", "--without", "outside,"},
                                            {"--engine", "tiled", "--without", "outside,list"},
                                            {"--engine", "exercise", "--without", "outside"},
                                            {"--frames", "0"},
                                            {"--frames", "-3"},
                                            {"--frames", "many"},
                                            {"--repeat", "0"},
                                            {"--repeat", "-1"},
                                            {"--repeat", "x"},
                                            {"--depth", "d.png"},
                                            {"--depth", "d"},
                                            {"--ids", "i.png"},
                                            {"--eye", "1,1,1", "--center", "1,1,1"}};
  if (stage_ >= "05")
    bad.insert(
        bad.end(),
        {{"--light", "1,2"}, {"--light", "x"}, {"--material", "1,2,3"}, {"--material", "q"}});
  if (stage_ >= "06") bad.insert(bad.end(), {{"--filter", "blurry"}, {"--wrap", "round"}});
  if (stage_ >= "07") bad.push_back({"--shader", "none_such"});
  for (std::vector<std::string> arguments : bad) {
    arguments.insert(arguments.begin(), {"--mesh", "builtin:cube", "--size", "16x12"});
    expect_refusal(stage_, arguments, 2);
  }
}

TEST_P(cli_viewer, flags_of_a_view_need_something_to_view) {
  expect_refusal(stage_, {"--eye", "1,2,3"}, 2);
  expect_refusal(stage_, {"--depth", "d.pfm"}, 2);
}

TEST_P(cli_viewer, an_unknown_built_in_mesh_is_refused) {
  expect_refusal(stage_, {"--mesh", "builtin:teapot"}, 1);
  expect_refusal(stage_, {"--mesh", "builtin:cube:-1"}, 1);
  expect_refusal(stage_, {"--mesh", "builtin:cube:x"}, 1);
}

TEST_P(cli_viewer, built_in_meshes_are_listed) {
  const ProcessResult result = run_here({"--mesh", "builtin:list"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  for (const char* name :
       {"cube", "wall", "grid", "uv_sphere", "icosphere", "torus", "torus_knot"}) {
    EXPECT_THAT(result.out, testing::HasSubstr(name));
  }
}

TEST_P(cli_viewer, every_listed_skip_can_be_switched_off) {
  const ProcessResult list = run_here({"--without", "list"});
  EXPECT_EQ(list.exit_status, 0) << list.err;
  std::string all;
  std::istringstream lines(list.out);
  for (std::string line; std::getline(lines, line);) all += (all.empty() ? "" : ",") + line;
  EXPECT_THAT(all, testing::HasSubstr("facing away,hidden clusters"));
  const ProcessResult result = run_here({"--mesh", "builtin:torus", "--engine", "tiled", "--size",
                                         "64x48", "--without", all, "--stats", "--out", "a.png"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  const nlohmann::json statistics = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_TRUE(statistics.is_object()) << result.out;
  int counts = 0;
  for (const auto& [name, value] : statistics.at("counts").items()) {
    if (!name.ends_with("_skipped") && !name.ends_with("_hidden")) continue;
    EXPECT_EQ(value.get<int>(), 0) << name;
    ++counts;
  }
  EXPECT_GE(counts, 4);
  EXPECT_THAT(
      run_here({"--mesh", "builtin:cube", "--engine", "tiled", "--without", "fog"}).err,
      testing::HasSubstr("--without fog: expected list or, between commas, some of outside"));
}

TEST_P(cli_viewer, frames_are_numbered_and_repeats_are_counted) {
  const ProcessResult frames =
      run_here({"--mesh", "builtin:cube", "--size", "16x12", "--frames", "3", "--out", "turn.png"});
  EXPECT_EQ(frames.exit_status, 0) << frames.err;
  EXPECT_THAT(
      files_in(scratch_.path()),
      testing::UnorderedElementsAre(testing::Key("turn.png"), testing::Key("turn_0000.png"),
                                    testing::Key("turn_0001.png"), testing::Key("turn_0002.png")));
  const ProcessResult repeats = run_here(
      {"--mesh", "builtin:cube", "--size", "16x12", "--repeat", "5", "--stats", "--out", "a.png"});
  EXPECT_EQ(repeats.exit_status, 0) << repeats.err;
  const nlohmann::json statistics = nlohmann::json::parse(repeats.out, nullptr, false);
  ASSERT_TRUE(statistics.is_object()) << repeats.out;
  EXPECT_THAT(repeats.out, testing::HasSubstr("median"));
}

TEST_P(cli_viewer, extension_chooses_the_format) {
  for (const std::string file : {"a.png", "a.jpg", "a.tga", "a.ppm"}) {
    EXPECT_EQ(run_here({"--mesh", "builtin:cube", "--size", "16x12", "--out", file}).exit_status, 0)
        << file;
    EXPECT_EQ(read_image<Rgb8>(scratch_ / file).width(), 16) << file;
  }
  expect_refusal(stage_, {"--mesh", "builtin:cube", "--size", "16x12", "--out", "a.gif"}, 1);
}

}  // namespace
}  // namespace rasterlab::cli

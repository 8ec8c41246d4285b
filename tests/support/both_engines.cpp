#include "tests/support/both_engines.h"

#include "common/image/files.h"

#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

struct Drawn {
  Image<Rgb8> color;
  Image<float> ids;
};

Drawn draw(const std::string& stage, const std::string& engine,
           const std::vector<std::string>& arguments) {
  const ScratchFolder folder;
  std::vector<std::string> command = {program(stage), "--engine", engine,    "--out",
                                      "picture.png",  "--ids",    "ids.pfm", "-q"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const ProcessResult result = run_process(command, {.folder = folder.path()});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  if (result.exit_status != 0) return {};
  return {read_image<Rgb8>(folder / "picture.png"), read_image<float>(folder / "ids.pfm")};
}

int largest_difference(const Rgb8& a, const Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

void expect_both_engines_draw_the_same(const std::string& stage,
                                       const std::vector<std::string>& arguments) {
  SCOPED_TRACE(stage + testing::PrintToString(arguments));
  const Drawn expected = draw(stage, "exercise", arguments);
  const Drawn actual = draw(stage, "tiled", arguments);
  ASSERT_EQ(actual.color.pixels().size(), expected.color.pixels().size());
  int drawn = 0;
  int covered_once = 0;
  int other_triangle = 0;
  int largest = 0;
  for (std::size_t i = 0; i < expected.ids.pixels().size(); ++i) {
    const float a = expected.ids.pixels()[i];
    const float b = actual.ids.pixels()[i];
    if (a >= 0) ++drawn;
    if ((a >= 0) != (b >= 0)) {
      ++covered_once;
    } else if (a != b) {
      ++other_triangle;
    } else {
      largest = std::max(largest,
                         largest_difference(expected.color.pixels()[i], actual.color.pixels()[i]));
    }
  }
  EXPECT_GT(drawn, 1000);
  EXPECT_EQ(covered_once, 0) << "pixels that only one of the two covers";
  EXPECT_LE(other_triangle, drawn / 1000) << "pixels that show different triangles";
  EXPECT_LE(largest, 1) << "code values";
}

}  // namespace rasterlab

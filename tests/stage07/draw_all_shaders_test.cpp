// Exercise 07.7 from outside: nobody includes a stage, its tests neither.
#include "common/image/files.h"

#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <iomanip>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr int gap = 1;
constexpr int frame_count = 24;

/// What `--shader list` names.
std::vector<std::string> shader_names() {
  std::vector<std::string> names;
  std::istringstream lines(run_process({program("07_shaders"), "--shader", "list"}).out);
  for (std::string line; std::getline(lines, line);) {
    std::string name;
    if (std::istringstream(line) >> name) names.push_back(name);
  }
  return names;
}

/// What exercise 07.7 leaves, each shader's picture in a frame being so many pixels wide and high.
class TurningLight {
 public:
  explicit TurningLight(int side) : side_(side) {
    const std::string size = std::to_string(side) + "x" + std::to_string(side);
    const ProcessResult result = run_process(
        {program("07_shaders"), "--exercise", "07.7", "--size", size, "--out", folder_.path()},
        {.limit = std::chrono::seconds(300)});
    EXPECT_EQ(result.exit_status, 0) << result.err;
  }

  std::filesystem::path file(const std::string& name) const {
    return folder_ / ("07.7_" + name + ".png");
  }

  /// The pictures of one frame, row by row.
  std::vector<Image<Rgb8>> cells_of_frame(int index) const {
    std::ostringstream name;
    name << "light_" << std::setw(4) << std::setfill('0') << index;
    const Image<Rgb8> sheet = read_image<Rgb8>(file(name.str()));
    std::vector<Image<Rgb8>> cells;
    for (int top = 0; top < sheet.height(); top += side_ + gap) {
      for (int left = 0; left < sheet.width(); left += side_ + gap) {
        Image<Rgb8>& cell = cells.emplace_back(side_, side_);
        for (int y = 0; y < side_; ++y) {
          for (int x = 0; x < side_; ++x) cell(x, y) = sheet(left + x, top + y);
        }
      }
    }
    return cells;
  }

 private:
  ScratchFolder folder_;
  int side_;
};

TEST(stage07_draw_all_shaders, each_of_the_list_has_a_picture_and_a_place_in_the_frame) {
  const TurningLight exercise(240);  // as large as each shader's own picture
  const std::vector<Image<Rgb8>> cells = exercise.cells_of_frame(0);
  ASSERT_GE(shader_names().size(), 18U);
  std::set<std::ptrdiff_t> places;
  for (const std::string& name : shader_names()) {
    ASSERT_TRUE(std::filesystem::exists(exercise.file(name))) << "no picture by " << name;
    const auto cell = std::find(cells.begin(), cells.end(), read_image<Rgb8>(exercise.file(name)));
    EXPECT_NE(cell, cells.end()) << "the first frame lacks what " << name << " draws";
    EXPECT_TRUE(places.insert(cell - cells.begin()).second) << name << " draws as another does";
  }
}

TEST(stage07_draw_all_shaders, the_light_turns_for_all_that_are_lit) {
  const TurningLight exercise(48);
  std::vector<Image<Rgb8>> before = exercise.cells_of_frame(0);
  std::vector<int> changes(before.size(), 0);
  for (int i = 1; i < frame_count; ++i) {
    const std::vector<Image<Rgb8>> now = exercise.cells_of_frame(i);
    for (std::size_t cell = 0; cell < now.size(); ++cell)
      changes[cell] += now[cell] != before[cell];
    before = now;
  }
  for (std::size_t cell = 0; cell < shader_names().size(); ++cell) {
    const bool is_lit = cell >= 2;  // the first two of the list are without light
    EXPECT_EQ(changes[cell], is_lit ? frame_count - 1 : 0)
        << "picture " << cell << " of the frame " << (is_lit ? "stands still" : "changes")
        << " while the light turns";
  }
}

TEST(stage07_draw_all_shaders, one_file_plays_every_frame_without_end) {
  const TurningLight exercise(8);
  const std::string bytes = read_file(exercise.file("light"));
  const std::size_t control = bytes.find("acTL");
  ASSERT_NE(control, std::string::npos) << "07.7_light.png is no animated PNG";
  EXPECT_EQ(static_cast<int>(bytes.at(control + 7)), frame_count) << "frames";
  EXPECT_EQ(static_cast<int>(bytes.at(control + 11)), 0) << "0 plays: without end";
}

}  // namespace
}  // namespace rasterlab

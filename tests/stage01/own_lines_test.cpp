// 01_lines as its users run it: --lines, convert, and what exercise 01.1 leaves.
#include "common/image/files.h"
#include "common/lines/bresenham.h"
#include "common/lines/draw_line_gradient.h"
#include "common/lines/draw_pixels.h"

#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

using testing::HasSubstr;

class OwnLines : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& content) {
    std::ofstream(scratch_ / name, std::ios::binary) << content;
    return scratch_ / name;
  }

  ProcessResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program("01_lines"));
    return run_process(arguments, {.folder = scratch_.path()});
  }

  ProcessResult draw(const std::string& content, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {
        "--lines", file("lines.txt", content), "--size", "20x10", "--out", "out.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  bool nothing_written() const { return !std::filesystem::exists(scratch_ / "out.png"); }

  ScratchFolder scratch_;
};
using stage01_own_lines = OwnLines;

TEST_F(stage01_own_lines, colours_comments_and_line_ends) {
  const ProcessResult result = draw(
      "# my lines\r\n"
      "0 0 19 9\r\n"
      "\r\n"
      "  19\t0 0 9 255 0 0   # red\n"
      "0 5 19 5 0 255 0 0 0 255\n"
      "-1000000000 3 +1000000000 4 10 20 30\n"
      "2.0 2e0 2 2");  // whole numbers, and no line's end
  EXPECT_EQ(result.exit_status, 0) << result.err;
  Image<Rgb8> expected(20, 10);
  draw_pixels(expected, line_bresenham({0, 0}, {19, 9}), {255, 255, 255});
  draw_pixels(expected, line_bresenham({19, 0}, {0, 9}), {255, 0, 0});
  draw_line_gradient(expected, {0, 5}, Color(0, 1, 0), {19, 5}, Color(0, 0, 1));
  for (int x = 0; x < 20; ++x) expected(x, 4) = {10, 20, 30};
  expected(2, 2) = {255, 255, 255};
  EXPECT_EQ(read_image<Rgb8>(scratch_ / "out.png"), expected);
}

TEST_F(stage01_own_lines, bad_rows_are_refused_by_number) {
  for (const auto& [content, expected] : std::vector<std::pair<std::string, std::string>>{
           {"0 0 5 5\n1 2 3\n",
            "lines.txt:2: expected x0 y0 x1 y1 [r g b [r g b]], found 3 numbers"},
           {"0 0 5 5 1\n", "lines.txt:1: expected"},
           {"\n\n0 0 five 5\n", "lines.txt:3: expected a number, found 'five'"},
           {"0 0 5 nan\n", "lines.txt:1: expected a number, found 'nan'"},
           {"0 0 5 1e999\n", "lines.txt:1: expected a number"},
           {"0 0 5 0x10\n", "lines.txt:1: expected a number, found '0x10'"},
           {"0 0.5 5 5\n", "lines.txt:1: expected whole pixels"},
           {"0 0 1073741825 5\n", "lines.txt:1: expected coordinates within"},
           {"0 0 5 5 0 0 256\n", "lines.txt:1: expected colours from 0 to 255"},
           {"0 0 5 5 0 -1 0\n", "lines.txt:1: expected colours from 0 to 255"},
           {std::string("\0\xFF\x10", 3), "lines.txt:1: expected a number"}}) {
    const ProcessResult result = draw(content);
    EXPECT_EQ(result.exit_status, 1) << content;
    EXPECT_THAT(result.err, HasSubstr(expected));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
        << "one line: " << result.err;
    EXPECT_TRUE(nothing_written()) << content;
  }
}

TEST_F(stage01_own_lines, files_that_are_none) {
  EXPECT_EQ(run({"--lines", "nowhere.txt", "--out", "out.png"}).exit_status, 1);
  EXPECT_EQ(run({"--lines", ".", "--out", "out.png"}).exit_status, 1);
  EXPECT_EQ(run({"--lines"}).exit_status, 2);
  EXPECT_TRUE(nothing_written());
}

TEST_F(stage01_own_lines, an_empty_file_is_an_empty_picture) {
  EXPECT_EQ(draw("# nothing\n").exit_status, 0);
  EXPECT_EQ(read_image<Rgb8>(scratch_ / "out.png"), Image<Rgb8>(20, 10));
}

TEST_F(stage01_own_lines, rungs_can_be_chosen) {
  EXPECT_EQ(draw("0 0 19 9\n", {"--algorithm", "ten_steps"}).exit_status, 0);
  const Image<Rgb8> image = read_image<Rgb8>(scratch_ / "out.png");
  EXPECT_EQ(std::count(image.pixels().begin(), image.pixels().end(), Rgb8{255, 255, 255}), 10);
  EXPECT_EQ(draw("0 0 19 9\n", {"--algorithm", "magic"}).exit_status, 2);
  EXPECT_EQ(draw("0 0 1000000000 9\n", {"--algorithm", "split_fraction"}).exit_status, 1);
}

TEST_F(stage01_own_lines, statistics_say_what_was_left_out) {
  const ProcessResult result = draw("0 0 19 0\n-5 -5 -1 -1\n30 0 30 9\n", {"--stats"});
  const nlohmann::json statistics = nlohmann::json::parse(result.out);
  EXPECT_EQ(statistics.at("lines"), 3);
  EXPECT_EQ(statistics.at("lines_outside"), 2);
  EXPECT_EQ(statistics.at("pixels"), 20);
}

TEST_F(stage01_own_lines, a_hundred_thousand_rows) {
  std::string rows;
  for (int i = 0; i < 100000; ++i)
    rows += std::to_string(i % 20) + " 0 " + std::to_string(i % 7) + " 9 1 2 3\n";
  EXPECT_EQ(draw(rows).exit_status, 0);
}

using stage01_convert = OwnLines;

TEST_F(stage01_convert, between_formats) {
  Image<Rgb8> image(4, 3);
  image(1, 0) = {255, 0, 0};
  image(3, 2) = {0, 0, 255};
  write_image(scratch_ / "in.png", image);
  for (const std::string extension : {"tga", "ppm", "png"}) {
    const std::string out = "out." + extension;
    EXPECT_EQ(run({"convert", "in.png", out}).exit_status, 0);
    EXPECT_EQ(read_image<Rgb8>(scratch_ / out), image) << out;
  }
  EXPECT_EQ(run({"convert", "in.png", "out.xyz"}).exit_status, 1);
  EXPECT_EQ(run({"convert", "missing.png", "out.png"}).exit_status, 1);
  EXPECT_EQ(run({"convert", "in.png"}).exit_status, 2);
}

using stage01_image = OwnLines;

TEST_F(stage01_image, a_failed_check_leaves_its_call_stack) {
  const ProcessResult result = run({"--exercise", "01.1", "--out", "results"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("pixel (91, 10) is outside the image of 90x10 pixels"));
  std::ifstream log(scratch_ / "results" / "backtrace_log.txt");
  const std::string text(std::istreambuf_iterator<char>(log), {});
  EXPECT_THAT(text, HasSubstr("(91, 10)"));
  EXPECT_THAT(text, HasSubstr("image_container")) << "the names of the functions that led there";
}

}  // namespace
}  // namespace rasterlab

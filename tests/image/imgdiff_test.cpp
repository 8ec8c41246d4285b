#include "common/image/files.h"
#include "common/image/operations.h"

#include "tests/image/corners.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <fstream>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::HasSubstr;

class cli_imgdiff : public testing::Test {
 protected:
  cli_imgdiff() {
    write_image(folder / "a.png", four_corners());
    write_image(folder / "a.ppm", four_corners());
    write_image(folder / "flipped.png", flipped_vertically(four_corners()));
    Image<Rgb8> near = four_corners();
    near(3, 2) = {252, 0, 0};
    near(4, 2) = {253, 1, 0};
    write_image(folder / "near.png", near);
  }

  ProcessResult imgdiff(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program("imgdiff"));
    return run_process(arguments, {.folder = folder.path()});
  }

  ScratchFolder folder;
};

TEST_F(cli_imgdiff, same_is_silent) {
  for (const char* other : {"a.png", "a.ppm"}) {
    const ProcessResult result = imgdiff({"a.png", other});
    EXPECT_EQ(result.exit_status, 0);
    EXPECT_EQ(result.out + result.err, "");
  }
}

TEST_F(cli_imgdiff, different_says_how) {
  const ProcessResult result = imgdiff({"flipped.png", "a.png"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("2048 of 2048 pixels differ, the largest difference is 255"));
  EXPECT_THAT(result.out, HasSubstr("(0, 0) is (0, 0, 255), expected (255, 0, 0)"));
  EXPECT_THAT(result.out, HasSubstr("kind of wrong: flipped in y"));
}

TEST_F(cli_imgdiff, limits) {
  EXPECT_EQ(imgdiff({"near.png", "a.png"}).exit_status, 1);
  EXPECT_EQ(imgdiff({"near.png", "a.png", "--max-difference", "3"}).exit_status, 0);
  EXPECT_EQ(imgdiff({"near.png", "a.png", "--max-difference", "2.5"}).exit_status, 1);
  EXPECT_EQ(imgdiff({"near.png", "a.png", "--total-pixels", "2"}).exit_status, 0);
  EXPECT_EQ(imgdiff({"near.png", "a.png", "--total-pixels", "1"}).exit_status, 1);
  EXPECT_EQ(
      imgdiff({"near.png", "a.png", "--max-difference", "3", "--total-pixels", "2"}).exit_status,
      0);
  EXPECT_EQ(
      imgdiff({"near.png", "a.png", "--max-difference", "3", "--total-pixels", "1"}).exit_status,
      1);
  EXPECT_EQ(imgdiff({"near.png", "a.png", "--neighbor-radius", "2"}).exit_status, 1);
}

TEST_F(cli_imgdiff, writes_the_difference) {
  const ProcessResult result = imgdiff({"near.png", "a.png", "--out", "d.png"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.out, HasSubstr("wrote d.png\n"));
  EXPECT_EQ(read_image<Rgb8>(folder / "d.png")(3, 2), (Rgb8{255, 0, 0}));
  const ProcessResult same = imgdiff({"a.png", "a.png", "--out", "same.png", "-q"});
  EXPECT_EQ(same.exit_status, 0);
  EXPECT_EQ(same.out + same.err, "");
  EXPECT_EQ(read_image<Rgb8>(folder / "same.png"), Image<Rgb8>(64, 32));
}

TEST_F(cli_imgdiff, other_sizes_are_reported) {
  write_image(folder / "wide.png", four_corners(66, 32));
  const ProcessResult result = imgdiff({"wide.png", "a.png", "--total-pixels", "99999"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_EQ(result.out, "the size is 66x32, expected 64x32\n");
}

TEST_F(cli_imgdiff, floats) {
  Image<float> depth(3, 2, std::numeric_limits<float>::infinity());
  depth(0, 0) = 2;
  write_image(folder / "a.pfm", depth);
  depth(0, 0) = 2.001F;
  write_image(folder / "b.pfm", depth);
  EXPECT_EQ(imgdiff({"a.pfm", "a.pfm"}).exit_status, 0);
  EXPECT_EQ(imgdiff({"b.pfm", "a.pfm"}).exit_status, 1);
  EXPECT_EQ(imgdiff({"b.pfm", "a.pfm", "--max-difference", "0.002"}).exit_status, 0);
}

TEST_F(cli_imgdiff, help_is_complete) {
  const ProcessResult result = imgdiff({"--help"});
  EXPECT_EQ(result.exit_status, 0);
  for (const char* word : {"--max-difference", "--total-pixels", "--neighbor-radius", "--out",
                           "--quiet", "Exit status: 0", "PFM"}) {
    EXPECT_THAT(result.out, HasSubstr(word));
  }
}

TEST_F(cli_imgdiff, bad_usage_is_2) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"a.png"},
                                             {"a.png", "a.png", "a.png"},
                                             {"a.png", "a.png", "--tolerance", "3"},
                                             {"a.png", "a.png", "--max-difference", "many"},
                                             {"a.png", "a.png", "--max-difference", "-1"},
                                             {"a.png", "a.png", "--max-difference", "nan"},
                                             {"a.png", "a.png", "--total-pixels", "-1"},
                                             {"a.png", "a.png", "--total-pixels", "1.5"},
                                             {"a.png", "a.png", "--neighbor-radius", "-2"},
                                             {"a.png", "a.png", "--out"}}) {
    const ProcessResult result = imgdiff(arguments);
    EXPECT_EQ(result.exit_status, 2) << testing::PrintToString(arguments) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST_F(cli_imgdiff, bad_input_is_1_and_writes_nothing) {
  std::ofstream(folder / "empty.png").close();
  std::ofstream(folder / "noise.png") << "\x01\x7f noise";
  const std::string whole = read_file(folder / "a.png");
  write_file(folder / "cut.png", std::string_view(whole).substr(0, whole.size() / 2));
  for (const char* name : {"missing.png", ".", "empty.png", "noise.png", "cut.png"}) {
    const ProcessResult result = imgdiff({"a.png", name, "--out", "d.png"});
    EXPECT_EQ(result.exit_status, 1) << name;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, testing::StartsWith(std::string("imgdiff: ") + name + ": "));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "d.png"));
  }
}

}  // namespace
}  // namespace rasterlab

// Four coloured corners through every stage's executable: none flips, transposes or swaps colours.
#include "common/image/files.h"

#include "tests/house/repository.h"
#include "tests/support/expect_image.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <fstream>

#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

constexpr int width = 64;
constexpr int height = 32;

struct Quadrant {
  int x;  ///< 0 left, 1 right
  int y;  ///< 0 top, 1 bottom
  Rgb8 color;
};

/// Red top left, green top right, blue bottom left, white bottom right.
constexpr std::array<Quadrant, 4> quadrants{
    {{0, 0, {255, 0, 0}}, {1, 0, {0, 255, 0}}, {0, 1, {0, 0, 255}}, {1, 1, {255, 255, 255}}}};

Image<Rgb8> four_corners() {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image(x, y) = quadrants[static_cast<std::size_t>(2 * (2 * y / height) + 2 * x / width)].color;
    }
  }
  return image;
}

std::string color_text(const Rgb8& color) {
  return std::to_string(color.r) + " " + std::to_string(color.g) + " " + std::to_string(color.b);
}

/// Runs a stage that is to draw the corners, in the folder where its input is.
void expect_corners(const std::string& stage, std::vector<std::string> arguments,
                    const fs::path& folder) {
  arguments.insert(arguments.begin(), program(stage));
  if (!fs::exists(program(stage))) GTEST_SKIP() << stage << " is not in this tree";
  arguments.insert(arguments.end(), {"--out", "drawn.png"});
  SCOPED_TRACE(testing::PrintToString(arguments));
  const ProcessResult result = run_process(arguments, {.folder = folder});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  expect_image_matches(read_any_image(folder / "drawn.png"), AnyImage(four_corners()), {}, stage);
}

const std::string size_text = std::to_string(width) + "x" + std::to_string(height);

TEST(house_corners, stage_01_lines) {
  const ScratchFolder scratch;
  std::ofstream file(scratch / "corners.txt");
  for (const Quadrant& quadrant : quadrants) {
    const int left = quadrant.x * width / 2;
    for (int row = 0; row < height / 2; ++row) {
      const int y = quadrant.y * height / 2 + row;
      file << left << " " << y << " " << left + width / 2 - 1 << " " << y << " "
           << color_text(quadrant.color) << "\n";
    }
  }
  file.close();
  expect_corners("01_lines", {"--lines", "corners.txt", "--size", size_text}, scratch.path());
}

TEST(house_corners, stage_01_convert_to_every_format_and_back) {
  const ScratchFolder scratch;
  write_image(scratch / "corners.png", four_corners());
  for (const std::string extension : {"png", "tga", "ppm", "pfm"}) {
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"corners.png", "there." + extension},
          {"there." + extension, "back.png"}}) {
      const ProcessResult result =
          run_process({program("01_lines"), "convert", from, to}, {.folder = scratch.path()});
      ASSERT_EQ(result.exit_status, 0) << result.err;
    }
    expect_image_matches(read_image<Rgb8>(scratch / "back.png"), AnyImage(four_corners()), {},
                         extension);
  }
}

/// Two triangles for each quadrant, each corner written by `corner(x, y)` of window coordinates.
template <class Corner>
void write_triangles(const fs::path& path, const Corner& corner) {
  std::ofstream file(path);
  for (const Quadrant& quadrant : quadrants) {
    const int left = quadrant.x * width / 2;
    const int top = quadrant.y * height / 2;
    const int right = left + width / 2;
    const int bottom = top + height / 2;
    file << corner(left, top) << corner(right, top) << corner(left, bottom)
         << color_text(quadrant.color) << "\n"
         << corner(right, top) << corner(right, bottom) << corner(left, bottom)
         << color_text(quadrant.color) << "\n";
  }
}

TEST(house_corners, stage_02_triangles) {
  const ScratchFolder scratch;
  write_triangles(scratch / "corners.txt",
                  [](int x, int y) { return std::to_string(x) + " " + std::to_string(y) + " "; });
  expect_corners("02_triangles", {"--triangles", "corners.txt", "--size", size_text},
                 scratch.path());
}

TEST(house_corners, stage_03_triangles) {
  const ScratchFolder scratch;
  write_triangles(scratch / "corners.txt", [](int x, int y) {
    return std::to_string(x) + " " + std::to_string(y) + " 0.5 ";
  });
  expect_corners("03_zbuffer", {"--triangles", "corners.txt", "--size", size_text}, scratch.path());
}

/// The quadrants as coloured rectangles in z = 0, x from −2 to 2 and y from −1 to 1 (up), in the
/// dialect of course C.
void write_colored_mesh(const fs::path& path) {
  std::ofstream file(path);
  file << "OFF\n16 8 0\n";
  for (const Quadrant& quadrant : quadrants) {
    const int left = 2 * quadrant.x - 2;
    const int bottom = -quadrant.y;
    for (const auto& [x, y] : {std::pair{left, bottom},
                               {left + 2, bottom},
                               {left + 2, bottom + 1},
                               {left, bottom + 1}}) {
      file << x << " " << y << " 0 " << color_text(quadrant.color) << "\n";
    }
  }
  for (int first = 0; first < 16; first += 4) {
    file << "3 " << first << " " << first + 1 << " " << first + 2 << "\n3 " << first << " "
         << first + 2 << " " << first + 3 << "\n";
  }
}

const std::vector<std::string> straight_on{"--eye", "0,0,5",   "--center", "0,0,0",  "--up",
                                           "0,1,0", "--ortho", "2",        "--size", size_text};

std::vector<std::string> operator+(std::vector<std::string> first,
                                   const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(house_corners, stage_04_mesh) {
  const ScratchFolder scratch;
  write_colored_mesh(scratch / "corners.off");
  expect_corners("04_projection", std::vector<std::string>{"--mesh", "corners.off"} + straight_on,
                 scratch.path());
}

TEST(house_corners, stage_04_scene_whose_image_y_goes_down) {
  const ScratchFolder scratch;
  write_colored_mesh(scratch / "corners.off");
  // Five away with a focal length of 80 pixels, a unit is 16 pixels; up is where image y goes.
  std::ofstream(scratch / "corners.scene")
      << "corners.off\n0 0 5\n0 0 0\n0 -1 0\n80\n64 32\n1\n0 0 5 1\n1 0 0 1\n";
  expect_corners("04_projection", {"--scene", "corners.scene"}, scratch.path());
}

TEST(house_corners, stage_05_in_ambient_light) {
  const ScratchFolder scratch;
  write_colored_mesh(scratch / "corners.off");
  expect_corners(
      "05_lighting",
      std::vector<std::string>{"--mesh", "corners.off", "--material", "1,0,0,1"} + straight_on,
      scratch.path());
}

/// A rectangle with the picture of the corners on it, v up.
void write_textured_mesh(const fs::path& folder) {
  std::ofstream(folder / "corners.obj")
      << "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "f 1/1 2/2 3/3 4/4\n";
  write_image(folder / "corners.png", four_corners());
}

const std::vector<std::string> textured{"--mesh",     "corners.obj", "--texture", "corners.png",
                                        "--material", "1,0,0,1",     "--filter",  "nearest"};

TEST(house_corners, stage_06_texture) {
  const ScratchFolder scratch;
  write_textured_mesh(scratch.path());
  expect_corners("06_texture", textured + straight_on, scratch.path());
}

TEST(house_corners, stage_07_texture_by_exercise_and_engine) {
  const ScratchFolder scratch;
  write_textured_mesh(scratch.path());
  for (const std::string engine : {"exercise", "tiled"}) {
    expect_corners("07_shaders",
                   textured +
                       std::vector<std::string>{"--shader", "phong_texture", "--engine", engine} +
                       straight_on,
                   scratch.path());
  }
}

}  // namespace
}  // namespace rasterlab::house

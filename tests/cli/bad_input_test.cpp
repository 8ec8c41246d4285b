// Bad files of every kind to every executable that reads files: one clear line, the right exit
// status, nothing half-written, no crash.
#include "common/image/files.h"

#include "tests/cli/command_line.h"
#include "tests/support/places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::cli {
namespace {

namespace fs = std::filesystem;

/// An executable's way of being given a file: arguments in which FILE stands for it, and the
/// extension such a file has.
struct Entrance {
  std::string program;
  std::vector<std::string> arguments;
  std::string extension;
};

std::vector<Entrance> entrances() {
  std::vector<Entrance> all;
  const auto add = [&](const std::string& program, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& extensions) {
    if (!fs::exists(rasterlab::program(program))) return;
    for (const std::string& extension : extensions) all.push_back({program, arguments, extension});
  };
  const std::vector<std::string> images{".png", ".jpg", ".tga", ".ppm", ".pgm", ".pbm", ".pfm"};
  const std::vector<std::string> meshes{".off", ".obj", ".ply", ".stl", ".om"};
  add("01_lines", {"--lines", "FILE"}, {".txt"});
  add("01_lines", {"convert", "FILE", "copy.png"}, images);
  add("02_triangles", {"--triangles", "FILE"}, {".txt"});
  add("03_zbuffer", {"--triangles", "FILE"}, {".txt"});
  for (const std::string& stage : viewer_stages()) {
    add(stage, {"--mesh", "FILE", "--size", "16x12"}, meshes);
    add(stage, {"--scene", "FILE"}, {".scene"});
    const std::vector<std::string> wall{"--mesh", "builtin:wall", "--size", "16x12"};
    std::vector<std::string> flags;
    if (stage >= "06") flags.push_back("--texture");
    if (stage >= "07") flags.insert(flags.end(), {"--normal-map", "--specular-map"});
    for (const std::string& flag : flags) {
      std::vector<std::string> arguments = wall;
      arguments.insert(arguments.end(), {flag, "FILE"});
      add(stage, arguments, images);
    }
  }
  return all;
}

std::vector<std::string> with_file(std::vector<std::string> arguments, const fs::path& file) {
  std::replace(arguments.begin(), arguments.end(), std::string("FILE"), file.string());
  return arguments;
}

TEST(cli_bad_input, missing_folder_empty_and_noise) {
  const ScratchFolder files;
  for (const Entrance& entrance : entrances()) {
    for (const BadFile& bad : bad_files(files.path(), entrance.extension)) {
      // An empty list of primitives is a list; an empty picture or mesh is none.
      if (bad.what == "empty" && entrance.extension == ".txt") continue;
      SCOPED_TRACE(bad.what);
      expect_refusal(entrance.program, with_file(entrance.arguments, bad.path), 1);
    }
  }
}

/// A valid file of each kind that can be cut off, as bytes.
std::map<std::string, std::string> valid_files() {
  const ScratchFolder scratch;
  Image<Rgb8> picture(24, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 24; ++x) {
      picture(x, y) = {static_cast<std::uint8_t>(10 * x), static_cast<std::uint8_t>(7 * x * y),
                       static_cast<std::uint8_t>(13 * y)};
    }
  }
  std::map<std::string, std::string> files;
  for (const std::string extension : {".png", ".jpg", ".tga", ".ppm", ".pgm", ".pfm"}) {
    write_image(scratch / ("a" + extension), picture);
    files[extension] = read_file(scratch / ("a" + extension));
  }
  files[".off"] = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  files[".ply"] =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
      "0 1 2\n";
  files[".scene"] =
      "builtin:cube\n0 0 -4\n0 0 0\n0 -1 0\n200\n64 48\n0.2\n0 0 -4 1\n0.2 0.8 0.6 32\n";
  return files;
}

TEST(cli_bad_input, truncated) {
  const ScratchFolder scratch;
  const std::map<std::string, std::string> valid = valid_files();
  for (const Entrance& entrance : entrances()) {
    const auto found = valid.find(entrance.extension);
    if (found == valid.end()) continue;
    const std::string& whole = found->second;
    const fs::path file = scratch / ("cut" + entrance.extension);
    for (const std::size_t length :
         {std::size_t{2}, whole.size() / 4, whole.size() / 2, whole.size() * 3 / 4}) {
      SCOPED_TRACE(std::to_string(length) + " of " + std::to_string(whole.size()) + " bytes");
      write_file(file, whole.substr(0, length));
      expect_refusal(entrance.program, with_file(entrance.arguments, file), 1);
    }
  }
}

TEST(cli_bad_input, headers_that_lie) {
  const ScratchFolder scratch;
  const std::map<std::string, std::string> lies{
      {".ppm", "P6 60000 60000 255\nabc"},
      {".pgm", "P5 16384 16384 65535\n"},
      {".pfm", "PF\n-3 4\n-1.0\n"},
      {".pbm", "P1\n4 4\n0 1 2 0\n"},
      {".off", "OFF\n2000000000 2000000000 0\n0 0 0\n"},
      {".ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float "
       "x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"},
      {".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n"},
      {".scene",
       "nowhere.off\n0 0 -4\n0 0 0\n0 -1 0\n200\n64 48\n0.2\n0 0 -4 1\n0.2 0.8 0.6 32\n"}};
  for (const Entrance& entrance : entrances()) {
    const auto found = lies.find(entrance.extension);
    if (found == lies.end()) continue;
    const fs::path file = scratch / ("lie" + entrance.extension);
    write_file(file, found->second);
    expect_refusal(entrance.program, with_file(entrance.arguments, file), 1);
  }
}

TEST(cli_bad_input, lines_of_primitives_are_named_by_number) {
  const ScratchFolder scratch;
  const std::map<std::string, std::string> bad{
      {"01_lines", "# two good\n0 0 5 5\n1 1 9 9 1 0 0\n3 4 5\n"},
      {"02_triangles", "# two good\n0 0 9 0 0 9\n0 0 9 0 0 9 1 0 0\n0 0 9 x 0 9\n"},
      {"03_zbuffer", "# two good\n0 0 0 9 0 0 0 9 0\n0 0 0 9 0 0 0 9 0 1 0 0\n0 0 0 9 0\n"}};
  for (const Entrance& entrance : entrances()) {
    if (entrance.extension != ".txt") continue;
    const fs::path file = scratch / "primitives.txt";
    write_file(file, bad.at(entrance.program));
    expect_refusal(entrance.program, with_file(entrance.arguments, file), 1);
    const ProcessResult result =
        run(entrance.program, with_file(entrance.arguments, file), scratch.path());
    EXPECT_THAT(result.err,
                testing::AllOf(testing::HasSubstr("primitives.txt"), testing::HasSubstr("4")));
  }
}

TEST(cli_bad_input, assimp_models_made_to_break_readers) {
  const fs::path folder = test_models_folder() / "invalid";
  if (!fs::exists(folder))
    GTEST_SKIP() << "NOT CHECKED: " << folder << " is missing (Debian: assimp-testmodels)";
  for (const auto& entry : fs::directory_iterator(folder)) {
    for (const std::string& stage : viewer_stages()) {
      expect_refusal(stage, {"--mesh", entry.path(), "--size", "16x12"}, 1);
    }
  }
}

TEST(cli_bad_input, an_older_result_survives_a_failed_run) {
  const ScratchFolder scratch;
  for (const std::string& stage : viewer_stages()) {
    write_file(scratch / "old.png", "what was there");
    const ProcessResult result =
        run(stage, {"--mesh", "missing.off", "--out", "old.png"}, scratch.path());
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_EQ(read_file(scratch / "old.png"), "what was there");
  }
}

}  // namespace
}  // namespace rasterlab::cli

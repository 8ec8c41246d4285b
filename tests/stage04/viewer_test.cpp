// Stage 04 as a user runs it on any mesh.
#include "common/image/bytes.h"
#include "common/image/files.h"
#include "common/projection/draw_mesh.h"
#include "common/viewer/camera.h"

#include "tests/support/both_engines.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class stage04_viewer : public testing::Test {
 protected:
  ProcessResult run(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {program("04_projection"), "--out",
                                        (folder_ / "a.png").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, {.folder = folder_.path()});
  }

  Image<Rgb8> picture(const std::vector<std::string>& arguments) const {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return read_image<Rgb8>(folder_ / "a.png");
  }

  void expect_usage_error(const std::vector<std::string>& arguments,
                          const std::string& message) const {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_status, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png")) << "nothing is written";
  }

  ScratchFolder folder_;
};

int drawn(const Image<Rgb8>& image) {
  return static_cast<int>(
      std::count_if(image.pixels().begin(), image.pixels().end(), [](const Rgb8& pixel) {
        return !(pixel == Rgb8{0, 0, 0});
      }));
}

TEST_F(stage04_viewer, without_a_camera_the_mesh_fills_the_picture_without_touching_its_border) {
  for (const char* mesh : {"builtin:cube", "builtin:torus", "builtin:wall", "builtin:grid"}) {
    for (const char* size : {"120x90", "60x120"}) {
      const Image<Rgb8> image = picture({"--mesh", mesh, "--size", size, "--color", "1,1,1"});
      const int last_x = image.width() - 1;
      const int last_y = image.height() - 1;
      int border = 0;
      for (int x = 0; x <= last_x; ++x) {
        border += image(x, 0) == Rgb8{} && image(x, last_y) == Rgb8{} ? 0 : 1;
      }
      for (int y = 0; y <= last_y; ++y) {
        border += image(0, y) == Rgb8{} && image(last_x, y) == Rgb8{} ? 0 : 1;
      }
      EXPECT_EQ(border, 0) << mesh << " " << size;
      EXPECT_GT(drawn(image), image.width() * image.height() / 16) << mesh << " " << size;
    }
  }
}

TEST_F(stage04_viewer, a_vertex_that_no_face_uses_does_not_push_the_camera_away) {
  const std::string triangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  write_file(folder_ / "triangle.obj", triangle);
  write_file(folder_ / "astray.obj", triangle + "v 1e10 20 3e10\n");
  const Image<Rgb8> expected = picture({"--mesh", "triangle.obj", "--size", "60x60"});
  EXPECT_GT(drawn(expected), 60 * 60 / 16);
  EXPECT_EQ(picture({"--mesh", "astray.obj", "--size", "60x60"}), expected);
}

TEST_F(stage04_viewer, depth_is_the_distance_along_the_view_axis_and_infinite_where_nothing_is) {
  run({"--mesh", "builtin:wall", "--eye", "0,0,3", "--fovy", "60", "--size", "40x40", "--depth",
       "d.pfm"});
  const Image<float> depth = read_image<float>(folder_ / "d.pfm");
  EXPECT_NEAR(depth(20, 20), 3, 1e-5);
  EXPECT_NEAR(depth(10, 28), 3, 1e-5) << "not the distance from the eye";
  EXPECT_EQ(depth(0, 0), std::numeric_limits<float>::infinity());
}

TEST_F(stage04_viewer, ids_are_indices_of_faces) {
  const std::vector<std::string> view = {"--mesh", "builtin:wall:1", "--eye", "0,0,3",
                                         "--size", "41x41",          "--ids"};
  auto arguments = view;
  arguments.emplace_back("ids.pfm");
  run(arguments);
  const Image<float> as_float = read_image<float>(folder_ / "ids.pfm");
  arguments.back() = "ids.pgm";
  run(arguments);
  const Image<std::uint16_t> as_grey = read_image<std::uint16_t>(folder_ / "ids.pgm");
  std::set<float> seen(as_float.pixels().begin(), as_float.pixels().end());
  EXPECT_THAT(seen, testing::ElementsAre(-1, 0, 1));
  for (std::size_t i = 0; i < as_float.pixels().size(); ++i) {
    const float id = as_float.pixels()[i];
    ASSERT_EQ(as_grey.pixels()[i], id < 0 ? 65535 : static_cast<int>(id));
  }
}

TEST_F(stage04_viewer, a_scene_gives_mesh_camera_and_size_and_flags_override_it) {
  write_file(folder_ / "a.scene",
             "builtin:cube\n0 0 5\n0 0 0\n0 -1 0\n100\n80 60\n1\n0 0 5 1\n.2 .8 .6 128\n");
  const Image<Rgb8> image = picture({"--scene", "a.scene"});
  EXPECT_EQ(image.width(), 80);
  EXPECT_EQ(image.height(), 60);
  EXPECT_NEAR(image(39, 29).r, 127, 4) << "the middle of the face z = 1 is (½, ½, 1)";
  EXPECT_NEAR(image(39, 29).g, 128, 4);
  // Its side is 2, 4 away: 100 · 2 / 4 = 50 pixels.
  EXPECT_EQ(drawn(image), 50 * 50);
  EXPECT_GT(image(20, 10).g, 200) << "up is up: (0, 1, 1) is top left";
  EXPECT_LT(image(20, 10).r, 50);
  EXPECT_EQ(drawn(picture({"--scene", "a.scene", "--eye", "0,0,11"})), 20 * 20);
}

TEST_F(stage04_viewer, orthographic_size_does_not_depend_on_distance) {
  for (const char* eye : {"0,0,3", "0,0,30"}) {
    EXPECT_EQ(
        drawn(picture({"--mesh", "builtin:wall", "--eye", eye, "--ortho", "4", "--size", "80x80"})),
        40 * 40)
        << eye;
  }
}

TEST_F(stage04_viewer, near_and_far_planes_cut) {
  const std::vector<std::string> view = {"--mesh", "builtin:wall", "--eye",  "0,0,3",
                                         "--size", "40x40",        "--near", "1"};
  auto with_far = [&](const char* far) {
    auto arguments = view;
    arguments.insert(arguments.end(), {"--far", far});
    return drawn(picture(arguments));
  };
  EXPECT_EQ(with_far("2.9"), 0);
  EXPECT_GT(with_far("3.1"), 0);
  EXPECT_GT(with_far("inf"), 0);
}

TEST_F(stage04_viewer, culling_toward_the_camera) {
  const std::vector<std::string> from_behind = {"--mesh", "builtin:wall", "--eye", "0,0,-3",
                                                "--cull"};
  const auto with = [&](const char* cull) {
    auto arguments = from_behind;
    arguments.emplace_back(cull);
    return drawn(picture(arguments));
  };
  EXPECT_EQ(with("back"), 0);
  EXPECT_EQ(with("front"), with("none"));
}

// The pictures in an animated PNG, taken apart by the chunks' own rules.
std::vector<Image<Rgb8>> frames_of(const std::filesystem::path& path,
                                   const std::filesystem::path& scratch) {
  const std::string file = read_file(path);
  const std::string signature = file.substr(0, 8);
  const auto number = [&](std::size_t at) {
    return std::stoul([&] {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(file[at + i]);
      }
      return std::to_string(value);
    }());
  };
  std::string header;
  std::vector<std::string> pixels;
  for (std::size_t at = 8; at < file.size(); at += 12 + number(at)) {
    const std::string type = file.substr(at + 4, 4);
    const std::string content = file.substr(at + 8, number(at));
    if (type == "IHDR") header = file.substr(at, 12 + number(at));
    if (type == "fcTL") pixels.emplace_back();
    if (type == "IDAT") pixels.back() += content;
    if (type == "fdAT") pixels.back() += content.substr(4);
  }
  const auto checksum = [](const std::string& bytes) {
    std::uint32_t crc = ~0U;
    for (const char byte : bytes) {
      crc ^= static_cast<unsigned char>(byte);
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xEDB88320U & (~(crc & 1U) + 1U));
    }
    return ~crc;
  };
  const auto bytes = [](std::uint32_t value) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255U);
    return text;
  };
  const auto chunk = [&](const std::string& type, const std::string& content) {
    return bytes(static_cast<std::uint32_t>(content.size())) + type + content +
           bytes(checksum(type + content));
  };
  std::vector<Image<Rgb8>> frames;
  for (const std::string& compressed : pixels) {
    write_file(scratch, signature + header + chunk("IDAT", compressed) + chunk("IEND", ""));
    frames.push_back(read_image<Rgb8>(scratch));
  }
  return frames;
}

TEST_F(stage04_viewer, frames_go_round_once_and_one_file_plays_them) {
  const ProcessResult result =
      run({"--mesh", "builtin:cube", "--frames", "8", "--turntable", "--size", "48x36"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  std::vector<Image<Rgb8>> frames;
  for (int i = 0; i < 8; ++i) {
    frames.push_back(read_image<Rgb8>(folder_ / ("a_000" + std::to_string(i) + ".png")));
  }
  EXPECT_FALSE(frames[0] == frames[1]);
  EXPECT_FALSE(frames[0] == frames[7]) << "the last frame is not the first again";
  EXPECT_EQ(frames_of(folder_ / "a.png", folder_ / "frame.png"), frames);
  EXPECT_EQ(read_image<Rgb8>(folder_ / "a.png"), frames[0]) << "a still viewer shows the first";
}

TEST_F(stage04_viewer, stats_give_times_and_counts) {
  const ProcessResult result =
      run({"--mesh", "builtin:cube:1", "--repeat", "5", "--stats", "--size", "64x48"});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const nlohmann::json statistics = nlohmann::json::parse(result.out);
  const nlohmann::json& times = statistics.at("draw_milliseconds");
  ASSERT_EQ(times.at("samples").size(), 5U);
  auto samples = times.at("samples").get<std::vector<double>>();
  std::sort(samples.begin(), samples.end());
  EXPECT_EQ(times.at("minimum"), samples[0]);
  EXPECT_EQ(times.at("median"), samples[2]);
  EXPECT_EQ(statistics.at("engine"), "exercise");
  EXPECT_EQ(statistics.at("triangles"), 12);
  EXPECT_EQ(statistics.at("counts").at("triangles"), 12);
  EXPECT_GT(statistics.at("counts").at("pixels_hidden"), 0);
}

TEST_F(stage04_viewer, lists_the_built_in_meshes) {
  const ProcessResult result = run({"--mesh", "builtin:list"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.out, HasSubstr("builtin:torus_knot"));
}

TEST_F(stage04_viewer, values_that_are_none_are_refused_with_what_was_expected) {
  expect_usage_error({"--mesh", "builtin:cube", "--eye", "1,2"}, "--eye 1,2: expected x,y,z");
  expect_usage_error({"--mesh", "builtin:cube", "--eye", "1,2,x"}, "--eye 1,2,x");
  expect_usage_error({"--mesh", "builtin:cube", "--eye", "1,2,nan"}, "finite");
  expect_usage_error({"--mesh", "builtin:cube", "--eye", "1,2,3", "--center", "1,2,3"},
                     "--eye and --center");
  expect_usage_error({"--mesh", "builtin:cube", "--up", "0,0,0"}, "--up");
  expect_usage_error({"--mesh", "builtin:cube", "--fovy", "180"}, "--fovy");
  expect_usage_error({"--mesh", "builtin:cube", "--near", "0"}, "--near");
  expect_usage_error({"--mesh", "builtin:cube", "--near", "5", "--far", "5"}, "--far");
  expect_usage_error({"--mesh", "builtin:cube", "--far", "never"}, "a number or inf");
  expect_usage_error({"--mesh", "builtin:cube", "--ortho", "0"}, "--ortho");
  expect_usage_error({"--mesh", "builtin:cube", "--ortho", "2", "--far", "inf"}, "--far inf");
  expect_usage_error({"--mesh", "builtin:cube", "--cull", "left"}, "none, back or front");
  expect_usage_error({"--mesh", "builtin:cube", "--color", "255,0,0"}, "each from 0 to 1");
  expect_usage_error({"--mesh", "builtin:cube", "--frames", "0"}, "a whole number from 1");
  expect_usage_error({"--mesh", "builtin:cube", "--repeat", "1.5"}, "a whole number from 1");
  expect_usage_error({"--mesh", "builtin:cube", "--turntable"}, "--frames");
  expect_usage_error({"--mesh", "builtin:cube", "--scene", "a.scene"}, "one of the two");
  expect_usage_error({"--mesh", "builtin:cube", "--exercise", "04.1"}, "--exercise");
  expect_usage_error({"--mesh", "builtin:cube", "--size", "40000x10"}, "32767");
  expect_usage_error({"--mesh", "builtin:icosphere:6", "--ids", "ids.pgm"}, ".pfm");
  expect_usage_error({"--eye", "1,2,3"}, "--mesh");
}

// Coloured vertices and coloured faces; from outside, and so close that triangles are cut.
TEST_F(stage04_viewer, both_engines_draw_the_same) {
  for (const char* shape : {"builtin:cube", "builtin:torus_knot:16", "builtin:icosphere:3"}) {
    expect_both_engines_draw_the_same("04_projection", {"--mesh", shape, "--size", "200x160"});
    expect_both_engines_draw_the_same(
        "04_projection", {"--mesh", shape, "--eye", "0.9,0.7,0.6", "--cull", "front", "--color",
                          "1,0.5,0.2", "--size", "160x200"});
  }
}

TEST_F(stage04_viewer, frames_make_the_folder_they_are_written_to) {
  const ProcessResult result =
      run_process({program("04_projection"), "--mesh", "builtin:cube", "--size", "20x20",
                   "--frames", "2", "--out", (folder_ / "not/yet").string()});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  for (const char* file : {"cube_0000.png", "cube_0001.png", "cube.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "not/yet" / file)) << file;
  }
}

TEST_F(stage04_viewer, flags_of_later_stages_are_unknown) {
  for (const char* flag : {"--light", "--material", "--texture", "--shader"}) {
    expect_usage_error({"--mesh", "builtin:cube", flag, "1,1,1,0"}, flag);
  }
}

TEST_F(stage04_viewer, a_mesh_that_cannot_be_read_is_one_line_and_status_1) {
  const ProcessResult result = run({"--mesh", "missing.obj"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.err, HasSubstr("04_projection: missing.obj"));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST(stage04_camera, raising_stops_short_of_the_pole_and_zooming_keeps_the_direction) {
  const Camera camera{.eye = {0, 0, 2},
                      .center = {0, 0, 0},
                      .up = {0, 1, 0},
                      .fovy = 40,
                      .ortho_height = {},
                      .near = {},
                      .far = {}};
  EXPECT_LT((raised(camera, 30).eye - Eigen::Vector3f(0, 1, std::sqrt(3.0F))).norm(), 1e-5F);
  const Eigen::Vector3f highest = raised(camera, 500).eye;
  EXPECT_NEAR(highest.normalized().y(), std::cos(std::numbers::pi / 180), 1e-5);
  EXPECT_LT((turned(camera, 90).eye - Eigen::Vector3f(2, 0, 0)).norm(), 1e-5F);
  EXPECT_LT((zoomed(camera, 0.5F).eye - Eigen::Vector3f(0, 0, 1)).norm(), 1e-6F);
}

}  // namespace
}  // namespace rasterlab

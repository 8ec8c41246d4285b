// Stage 05 as a user runs it on any mesh.
#include "common/image/bytes.h"
#include "common/image/files.h"

#include "tests/support/both_engines.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::HasSubstr;

class stage05_viewer : public testing::Test {
 protected:
  Image<Rgb8> picture(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {program("05_lighting"), "--out",
                                        (folder_ / "a.png").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run_process(command, {.folder = folder_.path()});
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return read_image<Rgb8>(folder_ / "a.png");
  }

  std::string usage_error(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {program("05_lighting")};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run_process(command, {.folder = folder_.path()});
    EXPECT_EQ(result.exit_status, 2);
    return result.err;
  }

  ScratchFolder folder_;
};

TEST_F(stage05_viewer, light_material_and_colour_come_from_the_flags) {
  const std::vector<std::string> wall = {"--mesh",     "builtin:wall:1", "--eye",   "0,0,3",
                                         "--size",     "33x33",          "--color", "1,0.5,0.25",
                                         "--material", "0.2,0.8,0,1",    "--light"};
  const auto lit_from = [&](const char* light) {
    auto arguments = wall;
    arguments.emplace_back(light);
    return picture(arguments)(16, 16);
  };
  EXPECT_EQ(lit_from("0,0,1,0"), (Rgb8{255, 128, 64})) << "straight on: 0.2 + 0.8";
  EXPECT_EQ(lit_from("0,0,-1,0"), (Rgb8{51, 26, 13})) << "from behind: 0.2";
  EXPECT_EQ(lit_from("1.7320508,0,1,0"), (Rgb8{153, 77, 38})) << "from 60°: 0.2 + 0.4";
  EXPECT_EQ(lit_from("0,0,2"), lit_from("0,0,2,1")) << "without w it is a point";
}

TEST_F(stage05_viewer, a_scene_brings_its_light_and_material) {
  write_file(folder_ / "a.scene",
             "builtin:wall:1\n0 0 3\n0 0 0\n0 -1 0\n33\n33 33\n0.5\n0 0 1 0 0.75\n0.2 0.4 0 1\n");
  // Ambient 0.5 · 0.2, diffuse 0.75 · 0.4; the wall has no colours: light grey.
  const Image<Rgb8> image = picture({"--scene", "a.scene", "--color", "1,1,1"});
  EXPECT_EQ(image(16, 16), (Rgb8{102, 102, 102}));
}

TEST_F(stage05_viewer, frames_turn_the_light_and_turntable_the_camera) {
  const std::vector<std::string> ball = {
      "--mesh", "builtin:icosphere:2", "--size", "32x24", "--frames", "4"};
  const Image<Rgb8> still = picture({"--mesh", "builtin:icosphere:2", "--size", "32x24"});
  picture(ball);
  const Image<Rgb8> lit_from_behind = read_image<Rgb8>(folder_ / "a_0002.png");
  EXPECT_EQ(read_image<Rgb8>(folder_ / "a_0000.png"), still);
  EXPECT_LT(lit_from_behind(16, 12).r, still(16, 12).r);
  const auto outline = [](const Image<Rgb8>& image) {
    std::vector<bool> drawn;
    for (const Rgb8& pixel : image.pixels()) drawn.push_back(!(pixel == Rgb8{}));
    return drawn;
  };
  EXPECT_EQ(outline(lit_from_behind), outline(still)) << "the camera stays";
}

TEST_F(stage05_viewer, both_engines_draw_the_same) {
  for (const char* shape : {"builtin:cube", "builtin:torus_knot:16", "builtin:icosphere:3"}) {
    expect_both_engines_draw_the_same("05_lighting", {"--mesh", shape, "--size", "200x160"});
    expect_both_engines_draw_the_same(
        "05_lighting", {"--mesh", shape, "--light", "1,2,0.5,1", "--eye", "0.9,0.7,0.6", "--cull",
                        "front", "--color", "1,0.5,0.2", "--size", "160x200"});
  }
}

TEST_F(stage05_viewer, lights_and_materials_that_are_none_are_refused) {
  EXPECT_THAT(usage_error({"--mesh", "builtin:cube", "--light", "0,0,0,0"}),
              HasSubstr("not all 0"));
  EXPECT_THAT(usage_error({"--mesh", "builtin:cube", "--light", "1,2"}), HasSubstr("x,y,z,w"));
  EXPECT_THAT(usage_error({"--mesh", "builtin:cube", "--material", "1,1,1,-1"}),
              HasSubstr("none below 0"));
}

}  // namespace
}  // namespace rasterlab

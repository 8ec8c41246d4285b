// Stage 06 as a user runs it on any mesh.
#include "common/engine/simd_target.h"
#include "common/image/bytes.h"
#include "common/image/files.h"
#include "common/texture/sample.h"

#include "tests/support/both_engines.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

TEST(stage06_viewer, both_engines_draw_the_same) {
  const std::string planet = source_folder() / "data/planet_color.png";
  for (const char* filter : {"nearest", "bilinear", "mip-mapped", "trilinear", "anisotropic"}) {
    expect_both_engines_draw_the_same(
        "06_texture", {"--mesh", "builtin:uv_sphere:24", "--texture", planet, "--filter", filter,
                       "--eye", "0.9,0.7,0.6", "--size", "200x160"});
  }
  for (const char* shape : {"builtin:cube", "builtin:torus_knot:16"}) {
    expect_both_engines_draw_the_same(
        "06_texture", {"--mesh", shape, "--material", "0.2,0.8,0.6,30", "--size", "200x160"});
  }
}

// From near by, where the widest one finds texels that pixels share by a way of its own.
TEST(stage06_viewer, instruction_sets_magnify_a_texture_to_the_same_bytes) {
  const auto picture = [](SimdTarget target, const std::string& eye) {
    const ScratchFolder folder;
    const ProcessResult result = run_process(
        {program("06_texture"), "--engine", "tiled", "--simd", std::string(name_of(target)),
         "--mesh", "builtin:uv_sphere:12", "--texture", source_folder() / "data/planet_color.png",
         "--eye=" + eye, "--size", "200x150", "--out", "picture.png", "-q"},
        {.folder = folder.path()});
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return read_image<Rgb8>(folder / "picture.png");
  };
  for (const char* eye : {"1.15,0.05,0.1", "-1.1,0.3,0.02"}) {
    const Image<Rgb8> expected = picture(SimdTarget::scalar, eye);
    for (const SimdTarget target : supported_simd_targets()) {
      EXPECT_EQ(picture(target, eye), expected) << name_of(target) << " from " << eye;
    }
  }
}

TEST(stage06_viewer, levels_no_filter_reads_are_not_made) {
  const ScratchFolder folder;
  const auto levels_skipped = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {program("06_texture"),
                                        "--engine",
                                        "tiled",
                                        "--mesh",
                                        "builtin:uv_sphere:12",
                                        "--texture",
                                        source_folder() / "data/planet_color.png",
                                        "--size",
                                        "100x75",
                                        "--stats",
                                        "--out",
                                        "a.png"};
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult result = run_process(command, {.folder = folder.path()});
    EXPECT_EQ(result.exit_status, 0) << result.err;
    const nlohmann::json statistics = nlohmann::json::parse(result.out, nullptr, false);
    return statistics.at("counts").at("levels_skipped").get<int>();
  };
  for (const FilterRung& rung : filter_ladder()) {
    const bool reads_one = rung.filter == Filter::nearest || rung.filter == Filter::bilinear;
    EXPECT_EQ(levels_skipped({"--filter", rung.name}), reads_one ? 9 : 0) << "of 512 × 256 texels";
    const std::string expected = read_file(folder / "a.png");
    EXPECT_EQ(levels_skipped({"--filter", rung.name, "--without", "unread levels"}), 0);
    EXPECT_TRUE(read_file(folder / "a.png") == expected) << rung.name << " reads what isn't made";
  }
}

}  // namespace
}  // namespace rasterlab

// Every exercise of stage 07 from outside: it writes the pictures its manifest names, and something
// is drawn in each.
#include "common/image/files.h"

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

nlohmann::json exercise(const std::string& id) {
  const std::string manifest = read_file(source_folder() / "07_shaders/exercises.json");
  const nlohmann::json parsed = nlohmann::json::parse(manifest);
  for (const nlohmann::json& entry : parsed.at("exercises")) {
    if (entry.at("id") == id) return entry;
  }
  throw std::out_of_range(id);
}

void expect_pictures(const std::string& id) {
  const ScratchFolder folder;
  const ProcessResult result =
      run_process({program("07_shaders"), "--exercise", id, "--out", folder.path()});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const nlohmann::json entry = exercise(id);
  for (const std::string name : entry.at("writes")) {
    if (name.find('*') != std::string::npos || !name.ends_with(".png")) continue;
    const Image<Rgb8> picture = read_image<Rgb8>(folder / name);
    const auto drawn = std::count_if(picture.pixels().begin(), picture.pixels().end(),
                                     [](const Rgb8& pixel) { return !(pixel == Rgb8{}); });
    EXPECT_GT(static_cast<double>(drawn), 0.02 * static_cast<double>(picture.pixels().size()))
        << name;
  }
}

TEST(stage07_exercises, loop) {
  expect_pictures("07.1");
}
TEST(stage07_exercises, four_simple_shaders) {
  expect_pictures("07.2");
}
TEST(stage07_exercises, quantized) {
  expect_pictures("07.3");
}
TEST(stage07_exercises, normal_maps) {
  expect_pictures("07.4");
}
TEST(stage07_exercises, culler) {
  expect_pictures("07.5");
}
TEST(stage07_exercises, four_phong_shaders) {
  expect_pictures("07.6");
}
TEST(stage07_exercises, all_under_a_turning_light) {
  expect_pictures("07.7");
}
TEST(stage07_exercises, phong_at_every_pixel) {
  expect_pictures("07.8");
}

}  // namespace
}  // namespace rasterlab

// 03_zbuffer --triangles FILE --algorithm NAME.
#include "tests/support/own_triangles.h"

#include "common/image/files.h"
#include "common/zbuffer/visibility.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

using testing::HasSubstr;

class stage03_own_triangles : public OwnTriangles {
 protected:
  ProcessResult draw(const std::string& rows, std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"--size", "40x30"});
    return draw_rows("03_zbuffer", rows, flags);
  }

  Image<Rgb8> picture(const std::string& content, std::vector<std::string> more = {}) {
    const ProcessResult result = draw(content, std::move(more));
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return read_image<Rgb8>(scratch_ / "out.png");
  }
};

/// A red triangle, and a farther green one that comes later and covers it all.
const std::string near_then_far =
    "5 5 0.1 30 5 0.1 5 25 0.1 255 0 0\n0 0 0.2 80 0 0.2 0 60 0.2 0 255 0\n";

std::int64_t count(const Image<Rgb8>& image, const Rgb8& color) {
  return std::count(image.pixels().begin(), image.pixels().end(), color);
}

TEST_F(stage03_own_triangles, rungs_can_be_chosen) {
  const Image<Rgb8> right = picture(near_then_far);
  const std::int64_t red = count(right, {255, 0, 0});
  EXPECT_GT(red, 200);
  for (const VisibilityRung& rung : visibility_ladder) {
    const Image<Rgb8> image = picture(near_then_far, {"--algorithm", rung.name});
    if (std::string(rung.name) == "draw_order") {
      EXPECT_EQ(count(image, {255, 0, 0}), 0) << "the last one drawn wins";
    } else {
      EXPECT_EQ(image, right) << rung.name;
    }
  }
  EXPECT_EQ(draw(near_then_far, {"--algorithm", "magic"}).exit_status, 2);
}

TEST_F(stage03_own_triangles, fine_rungs_draw_what_the_depth_buffer_does) {
  std::mt19937 random(3);
  std::string rows;
  for (int i = 0; i < 40; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      rows += std::to_string(random() % 50) + ".25 " + std::to_string(random() % 40) + ".5 " +
              std::to_string(static_cast<double>(random() % 1900) / 1000 - 0.95) + " ";
    }
    for (int channel = 0; channel < 9; ++channel) rows += std::to_string(random() % 256) + " ";
    rows += "\n";
  }
  const Image<Rgb8> right = picture(rows);
  for (const char* rung : {"zbuffer_24", "zbuffer_float", "zbuffer_reversed"})
    EXPECT_EQ(picture(rows, {"--algorithm", rung}), right) << rung;
  EXPECT_NE(picture(rows, {"--algorithm", "painter"}), right) << "they pierce each other";
}

TEST_F(stage03_own_triangles, statistics_count_the_pixels_seen) {
  const auto seen = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--stats"});
    const ProcessResult result = draw("5 5 0 30 5 0 5 25 0\n", more);
    return nlohmann::json::parse(result.out).at("pixels_seen").get<int>();
  };
  EXPECT_GT(seen({}), 200);
  EXPECT_EQ(seen({"--algorithm", "painter"}), seen({}));
}

TEST_F(stage03_own_triangles, what_a_rung_cannot_draw_is_refused_by_line) {
  for (const auto& [rows, expected] : std::vector<std::pair<std::string, std::string>>{
           {"0 0 0 9 0 0 0 9 0\n0 0 0 9 0 1.5 0 9 0\n", "triangles.txt:2: expected z"},
           {"0 0 0 40000 0 0 0 9 0\n", "triangles.txt:1: expected x and y within"}}) {
    EXPECT_EQ(draw(rows).exit_status, 0) << "the depth buffer draws it";
    std::filesystem::remove(scratch_ / "out.png");
    const ProcessResult result = draw(rows, {"--algorithm", "zbuffer_float"});
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.err, HasSubstr(expected));
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "out.png"));
  }
}

}  // namespace
}  // namespace rasterlab

// 02_triangles --triangles FILE --coverage FILE.pgm.
#include "tests/support/own_triangles.h"

#include "common/image/files.h"
#include "common/triangles/fill_ladder.h"

#include "tests/oracle/exact_triangle.h"
#include "tests/support/picture_text.h"

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

class stage02_own_triangles : public OwnTriangles {
 protected:
  ProcessResult draw(const std::string& rows, const std::string& size = "12x7",
                     std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"--coverage", "coverage.pgm", "--size", size});
    return draw_rows("02_triangles", rows, flags);
  }

  Image<std::uint16_t> coverage() const {
    return read_image<std::uint16_t>(scratch_ / "coverage.pgm");
  }
};

/// A coordinate on 1/256 pixel, in units of it.
using Units = std::array<std::array<int, 2>, 3>;

/// Of any shape and up to 20 pixels in size, in and around the picture; some are flat, collinear,
/// or have a corner twice.
Units random_triangle(std::mt19937& random, int width, int height) {
  const auto between = [&random](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  const int reach = 256 * between(1, 20);
  const int x = between(-20 * 256, (width + 20) * 256);
  const int y = between(-20 * 256, (height + 20) * 256);
  Units corners;
  for (auto& corner : corners) corner = {x + between(0, reach), y + between(0, reach)};
  switch (random() % 16) {
    case 0:
      corners[2] = corners[0];
      break;
    case 1:
      corners[1][1] = corners[2][1] = corners[0][1];
      break;
    case 2:
      for (std::size_t i = 0; i < 2; ++i) corners[2][i] = 2 * corners[1][i] - corners[0][i];
      break;
    default:
      break;
  }
  return corners;
}

oracle::GridTriangle on_grid(const Units& corners) {
  oracle::GridTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) triangle[k] = {corners[k][0], corners[k][1]};
  return triangle;
}

/// With six decimals, which snapping takes to the unit meant.
std::string row_of(const Units& corners) {
  std::string row;
  for (const auto& corner : corners) {
    for (const int units : corner) row += std::to_string(units / 256.0) + " ";
  }
  return row + "\n";
}

TEST_F(stage02_own_triangles, a_hundred_thousand_are_covered_as_integers_say) {
  constexpr int width = 320;
  constexpr int height = 240;
  std::mt19937 random(100000);
  std::string rows;
  std::vector<oracle::GridTriangle> exact;
  for (int i = 0; i < 100000; ++i) {
    const Units corners = random_triangle(random, width, height);
    rows += row_of(corners);
    exact.push_back(on_grid(corners));
  }
  const ProcessResult result = draw(rows, "320x240", {"--stats"});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  EXPECT_TRUE(coverage() == oracle::coverage(exact, width, height))
      << "some pixel is covered by another number of triangles";
  const nlohmann::json skipped = nlohmann::json::parse(result.out).at("skipped");
  EXPECT_GT(skipped.at("no_area"), 10000) << "too few without area to mean anything";
  EXPECT_GT(skipped.at("outside"), 1000) << "too few outside to mean anything";
}

// Colours that change now and then and at each row, and rows of three colours between.
TEST_F(stage02_own_triangles, each_covers_the_ones_before_it) {
  constexpr int width = 64;
  constexpr int height = 48;
  std::mt19937 random(7);
  Image<Rgb8> expected(width, height);
  std::string rows;
  std::int64_t pixels = 0;
  std::int64_t without = 0;
  std::string color = "255 255 255 ";
  Rgb8 pixel{255, 255, 255};
  for (unsigned i = 0; i < 6000; ++i) {
    const Units corners = random_triangle(random, width, height);
    if (random() % (i < 5000 ? 500U : 2U) == 0) {
      pixel = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()), 9};
      color = std::to_string(pixel.r) + " " + std::to_string(pixel.g) + " 9 ";
    }
    const std::string colors = i % 11 == 10 ? color + color + color : color;
    std::string row = row_of(corners);
    row.insert(row.size() - 1, colors);
    rows += row;
    const Image<std::uint16_t> covered = oracle::coverage({on_grid(corners)}, width, height);
    const std::int64_t before = pixels;
    for (std::size_t k = 0; k < covered.pixels().size(); ++k) {
      if (covered.pixels()[k] == 0) continue;
      expected.pixels()[k] = pixel;
      ++pixels;
    }
    without += pixels == before ? 1 : 0;
  }
  const ProcessResult result = draw_rows("02_triangles", rows, {"--size", "64x48", "--stats"});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  EXPECT_TRUE(read_image<Rgb8>(scratch_ / "out.png") == expected);
  const nlohmann::json statistics = nlohmann::json::parse(result.out);
  EXPECT_EQ(statistics.at("triangles"), 6000);
  EXPECT_EQ(statistics.at("pixels"), pixels);
  std::int64_t skipped = 0;
  for (const nlohmann::json& count : statistics.at("skipped")) skipped += count.get<std::int64_t>();
  EXPECT_EQ(skipped, without);
}

TEST_F(stage02_own_triangles, coverage_counts_and_colours_overwrite) {
  ASSERT_EQ(draw("# one, and one over it\r\n"
                 "1 1 9 1 1 6 255 0 0\r\n"
                 "\r\n"
                 "1 1 4 1 1 4\t0 255 0 0 255 0 0 255 0  # all corners green\n")
                .exit_status,
            0);
  EXPECT_TRUE(same_picture(picture_text_by(coverage(),
                                           [](std::uint16_t count) {
                                             return count == 0 ? '.' : count == 1 ? '#' : 'x';
                                           }),
                           {"............", ".xx#####....", ".x#####.....", ".####.......",
                            ".##.........", ".#..........", "............"}));
  const auto image = read_image<Rgb8>(scratch_ / "out.png");
  EXPECT_EQ(image(1, 1), (Rgb8{0, 255, 0})) << "the later triangle";
  EXPECT_EQ(image(1, 3), (Rgb8{255, 0, 0})) << "the earlier one, where no other came";
}

TEST_F(stage02_own_triangles, bad_rows_are_refused_by_number) {
  for (const auto& [content, expected] : std::vector<std::pair<std::string, std::string>>{
           {"0 0 5 0 0 5\n0 0 5 0 0\n", "triangles.txt:2: expected x0 y0 x1 y1 x2 y2"},
           {"0 0 5 0 0 5 1 2 3 4\n", "triangles.txt:1: expected x0 y0 x1 y1 x2 y2"},
           {"\n# none\n0 0 5 0 zero 5\n", "triangles.txt:3: expected a number, found 'zero'"},
           {"0 0 5 inf 0 5\n", "triangles.txt:1: expected a number, found 'inf'"},
           {"0 0 1073741825 0 0 5\n", "triangles.txt:1: expected coordinates within"},
           {"0 0 5 0 0 5 0 0 300\n", "triangles.txt:1: expected colours from 0 to 255"}}) {
    const ProcessResult result = draw(content);
    EXPECT_EQ(result.exit_status, 1) << content;
    EXPECT_THAT(result.err, HasSubstr(expected));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
        << "one line: " << result.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "out.png")) << content;
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "coverage.pgm")) << content;
  }
}

TEST_F(stage02_own_triangles, coverage_needs_triangles_and_a_pgm) {
  const auto status = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program("02_triangles"));
    return run_process(arguments, {.folder = scratch_.path()}).exit_status;
  };
  EXPECT_EQ(status({"--coverage", "coverage.pgm"}), 2);
  write_file(scratch_ / "triangles.txt", "0 0 5 0 0 5\n");
  EXPECT_EQ(status({"--triangles", "triangles.txt", "--coverage", "coverage.png"}), 2);
}

TEST_F(stage02_own_triangles, from_a_billion_pixels_away) {
  ASSERT_EQ(draw("-1000000000 -1000000000 1000000000 -1000000000 0 1000000000\n").exit_status, 0);
  EXPECT_TRUE(covers_exactly(coverage(), PictureText(7, std::string(12, '#'))))
      << "the picture is inside";
}

TEST_F(stage02_own_triangles, rungs_can_be_chosen) {
  for (const FillRung& rung : fill_ladder) {
    ASSERT_EQ(draw("1 1 9 1 1 6\n", "12x7", {"--algorithm", rung.name}).exit_status, 0);
    const auto image = read_image<Rgb8>(scratch_ / "out.png");
    EXPECT_TRUE(same_picture(picture_text(image), picture_text(coverage())))
        << rung.name << " counts other pixels than it draws";
  }
  EXPECT_EQ(draw("1 1 9 1 1 6\n", "12x7", {"--algorithm", "magic"}).exit_status, 2);
}

}  // namespace
}  // namespace rasterlab

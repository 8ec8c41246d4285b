// The gallery page: what tools/make_gallery.py puts into it, and how it behaves in a real browser.
#include "common/image/files.h"

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <fstream>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// Pixel (x, y) is `color(x, y)`.
template <class Function>
void write_square(const fs::path& path, const Function& color) {
  Image<Rgb8> image(16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x)
      image(x, y) = color(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y));
  }
  write_image(path, image);
}

/// A stage with one exercise, drawn, as gallery_selftest.js expects it; the page is at
/// folder/out/index.html.
ProcessResult make_small_gallery(const fs::path& folder) {
  write_text(folder / "01_lines/README.md", "# Stage 01: lines\n");
  write_text(folder / "01_lines/exercises.json", R"({"stage": "01_lines", "exercises": [
      {"id": "01.1", "title": "A square & more", "writes": ["01.1_a.png", "01.1_b.png", "01.1_lost.png"],
       "compare": [["01.1_a.png", "01.1_b.png"]]}]})");
  const fs::path out = folder / "out/01_lines";
  write_text(out / "01.1_points.txt", "(5,5) <6,6>\n");
  write_text(out / "01.1_depth.pfm", "Pf\n1 1\n-1.0\n0000");
  write_square(out / "01.1_a.png", [](std::uint8_t x, std::uint8_t y) { return Rgb8{x, y, 7}; });
  write_square(out / "01.1_b.png", [](std::uint8_t x, std::uint8_t y) { return Rgb8{y, x, 200}; });
  write_square(out / "01.10_other.png", [](std::uint8_t x, std::uint8_t y) {
    return Rgb8{x, x, y};
  });
  for (std::uint8_t frame = 0; frame < 3; ++frame) {
    write_square(out / ("01.1_light_000" + std::to_string(frame) + ".png"),
                 [frame](std::uint8_t x, std::uint8_t) {
                   return Rgb8{frame, x, x};
                 });
  }
  return run_process({"python3", (source_folder() / "tools/make_gallery.py").string(), "--stages",
                      folder.string(), "--out", (folder / "out/index.html").string()});
}

std::string read_text(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(house_gallery, page_holds_everything_and_needs_nothing) {
  const ScratchFolder scratch;
  const ProcessResult result = make_small_gallery(scratch.path());
  ASSERT_EQ(result.exit_status, 0) << result.err;
  EXPECT_EQ(result.out, "wrote " + (scratch / "out/index.html").string() + "\n");
  const std::string page = read_text(scratch / "out/index.html");
  EXPECT_THAT(page, testing::HasSubstr("Stage 01: lines"));
  EXPECT_THAT(page, testing::HasSubstr("\"missing\": [\"01.1_lost.png\"]"));
  EXPECT_THAT(page, testing::HasSubstr("\"files\": [\"01.1_depth.pfm\"]"));
  EXPECT_THAT(page, testing::HasSubstr("\"caption\": \"light\""));
  EXPECT_THAT(page, testing::ContainsRegex("Further pictures.*01.10_other.png"));
  EXPECT_FALSE(std::regex_search(page, std::regex("https?://|src=\"[^d]|url\\(")));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch / "out"), {}),
            2);  // the stage's folder and the page
}

TEST(house_gallery, stages_not_yet_run_are_listed_as_such) {
  const ScratchFolder scratch;
  write_text(scratch / "01_lines/exercises.json",
             R"({"exercises": [{"id": "01.1", "title": "t", "writes": ["01.1_a.png"]}]})");
  const ProcessResult result = run_process(
      {"python3", (source_folder() / "tools/make_gallery.py").string(), "-q", "--stages",
       scratch.path().string(), "--out", (scratch / "new/page.html").string()});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(read_text(scratch / "new/page.html"),
              testing::HasSubstr("\"missing\": [\"01.1_a.png\"]"));
}

TEST(house_gallery, bad_input_is_one_line) {
  const ScratchFolder scratch;
  const std::string page = (scratch / "index.html").string();
  const std::vector<std::string> command{
      "python3",  (source_folder() / "tools/make_gallery.py").string(),
      "--stages", scratch.path().string(),
      "--out",    page};
  for (const std::string& manifest :
       {std::string(), std::string("{"), std::string(R"({"exercises": [{}]})")}) {
    if (!manifest.empty()) write_text(scratch / "01_lines/exercises.json", manifest);
    const ProcessResult result = run_process(command);
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.err, testing::MatchesRegex("make_gallery: [^\n]*\n"));
    EXPECT_FALSE(fs::exists(page));
  }
}

TEST(house_gallery, zoom_readout_and_slider_work_in_a_browser) {
  const std::string chromium = RASTERLAB_CHROMIUM;
  if (chromium.empty())
    GTEST_SKIP() << "NOT CHECKED IN A BROWSER: Chromium is not installed (Debian: chromium)";
  const ScratchFolder scratch;
  ASSERT_EQ(make_small_gallery(scratch.path()).exit_status, 0);
  const fs::path page = scratch / "out/index.html";
  std::ofstream(page, std::ios::app)
      << "<script>" << read_text((source_folder() / "tests/house/gallery_selftest.js").string())
      << "</script>";
  const ProcessResult result = run_process(
      {chromium, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
       "--disable-background-networking", "--disable-component-update", "--disable-sync",
       "--user-data-dir=" + (scratch / "profile").string(), "--window-size=1200,900",
       "--virtual-time-budget=2000000", "--dump-dom", "file://" + page.string()},
      {.limit = std::chrono::seconds(120)});
  ASSERT_EQ(result.exit_status, 0) << result.err;
  // The page's own script, which names the element too, comes before it.
  const std::string start = "<pre id=\"selftest\">";
  const std::size_t begin = result.out.rfind(start);
  const std::size_t end = result.out.find("\nend</pre>", begin);
  ASSERT_NE(end, std::string::npos) << "the page's script did not reach its end\n" << result.err;
  const std::string report = result.out.substr(begin + start.size(), end - begin - start.size());
  EXPECT_THAT(report, testing::Not(testing::HasSubstr("not ok"))) << report;
  EXPECT_GE(std::count(report.begin(), report.end(), '\n') + 1, 16) << report;
}

}  // namespace
}  // namespace rasterlab

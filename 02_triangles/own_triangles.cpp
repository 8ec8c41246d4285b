#include "02_triangles/own_triangles.h"

#include "common/image/files.h"
#include "common/lines/number_rows.h"
#include "common/triangles/barycentric.h"
#include "common/triangles/coverage.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fill_triangle_list.h"
#include "common/triangles/rasterize.h"
#include "common/triangles/spans.h"

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

const RowFormat triangle_format{.description = "x0 y0 x1 y1 x2 y2 [r g b | r g b r g b r g b]",
                                .counts = {6, 9, 15}};

Corners corners_at(const NumberRow& row) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = {row.numbers[2 * i], row.numbers[2 * i + 1]};
  if (!within(corners, max_wide_coordinate))
    row.fail("expected coordinates within ±1073741824 (2^30)");
  return corners;
}

/// The rung that --algorithm asked for; the last when it did not.
const FillRung& asked_rung(const Run& run) {
  const std::string& name = run.settings().algorithm;
  if (name.empty()) return fill_ladder.back();
  const auto* rung =
      std::find_if(fill_ladder.begin(), fill_ladder.end(),
                   [&](const FillRung& candidate) { return candidate.name == name; });
  if (rung == fill_ladder.end())
    throw UsageError("--algorithm " + name + ": expected one of --algorithm list");
  return *rung;
}

/// What the triangles of a file make, filled and counted as they come.
class TriangleDrawing {
 public:
  TriangleDrawing(const Run& run, Size size, std::filesystem::path coverage_file)
      : rung_(asked_rung(run)),
        coverage_file_(std::move(coverage_file)),
        image_(size.width, size.height) {
    if (!coverage_file_.empty()) coverage_ = Coverage(size.width, size.height);
    if (!exact()) scratch_ = Image<Rgb8>(size.width, size.height);
  }

  void draw(const NumberRow& row) {
    const Corners corners = corners_at(row);
    ++triangles_;
    if (row.numbers.size() == 15) {
      draw_waiting();
      fill(corners, {color_at(row, 6), color_at(row, 9), color_at(row, 12)});
    } else {
      fill(corners, to_rgb8(row.numbers.size() == 9 ? color_at(row, 6) : Color(1, 1, 1)));
    }
  }

  void finish(Run& run) {
    draw_waiting();
    run.statistics()["triangles"] = triangles_;
    run.statistics()["pixels"] = pixels_;
    run.statistics()["skipped"] = skipped_;
    run.picture("triangles", image_);
    if (coverage_file_.empty()) return;
    write_image(coverage_file_, coverage_);
    run.announce(coverage_file_);
  }

 private:
  static constexpr std::size_t longest_list = 4096;

  bool exact() const { return &rung_ == &fill_ladder.back(); }

  void fill(const Corners& corners, const Rgb8& color) {
    if (!exact()) return fill_by_rung(corners, [&](int, int) { return color; });
    if (color != color_ || waiting_.size() == longest_list) draw_waiting();
    color_ = color;
    waiting_.push_back(corners);
  }

  /// Triangles of one colour that follow each other are drawn together.
  void draw_waiting() {
    const DrawnTriangles drawn = fill_triangle_list(image_, waiting_, color_);
    pixels_ += drawn.pixels;
    count_skipped(waiting_, drawn.triangles);
    if (!coverage_.empty()) {
      for (const Corners& corners : waiting_) cover(corners);
    }
    waiting_.clear();
  }

  void cover(const Corners& corners) {
    for_each_wide_span(corners, image_.width(), image_.height(), [&](int y, int begin, int end) {
      std::for_each(coverage_.row(y) + begin, coverage_.row(y) + end, &count_up);
    });
  }

  void fill(const Corners& corners, const std::array<Color, 3>& colors) {
    const auto blend = [&](const Eigen::Vector3d& weights) {
      const Eigen::Vector3f w = weights.cast<float>();
      return to_rgb8(w[0] * colors[0] + w[1] * colors[1] + w[2] * colors[2]);
    };
    if (!exact()) {
      return fill_by_rung(corners, [&](int x, int y) {
        return blend(barycentric(corners, {x + 0.5, y + 0.5}));
      });
    }
    const std::int64_t before = pixels_;
    rasterize_wide_triangle(
        corners, image_.width(), image_.height(),
        [&](int x, int y, const Eigen::Vector3d& weights) { set(x, y, blend(weights)); });
    count_skipped({&corners, 1}, pixels_ > before ? 1 : 0);
  }

  /// Covered as the rung says, coloured as `color_at(x, y)` says.
  template <class ColorAt>
  void fill_by_rung(const Corners& corners, ColorAt color_at) {
    const std::int64_t before = pixels_;
    for_each_drawn_pixel(rung_.fill, corners, scratch_,
                         [&](int x, int y) { set(x, y, color_at(x, y)); });
    count_skipped({&corners, 1}, pixels_ > before ? 1 : 0);
  }

  void set(int x, int y, const Rgb8& color) {
    image_(x, y) = color;
    if (!coverage_.empty()) count_up(coverage_(x, y));
    ++pixels_;
  }

  /// Counts why triangles have no pixel, when all but `drawn` of them have none.
  void count_skipped(std::span<const Corners> triangles, std::int64_t drawn) {
    std::int64_t skipped = std::ssize(triangles) - drawn;
    if (skipped == 0) return;
    for (const Corners& corners : triangles) {
      const std::string reason = reason_for_nothing(corners);
      if (reason.empty()) continue;
      ++skipped_[reason];
      --skipped;
    }
    skipped_["no_centre_covered"] += skipped;
  }

  /// Why a triangle cannot have a pixel; empty when it may.
  std::string reason_for_nothing(const Corners& corners) const {
    const PixelBox box = pixel_box(corners, image_.width(), image_.height());
    if (box.right < box.left || box.bottom < box.top) return "outside";
    const SnappedTriangle snapped = snap(corners, max_wide_coordinate);
    return cross<Int128>(snapped[0], snapped[1], snapped[2]) == 0 ? "no_area" : "";
  }

  const FillRung& rung_;
  std::filesystem::path coverage_file_;
  Image<Rgb8> image_;
  Coverage coverage_;    ///< empty when nobody asked for it
  Image<Rgb8> scratch_;  ///< black
  std::vector<Corners> waiting_;
  Rgb8 color_;  ///< of those
  std::int64_t triangles_ = 0;
  std::int64_t pixels_ = 0;  ///< drawn, each as often as it was
  std::map<std::string, std::int64_t> skipped_ = {
      {"no_area", 0}, {"no_centre_covered", 0}, {"outside", 0}};
};

struct Flags {
  std::filesystem::path triangles;
  std::filesystem::path coverage;
  const CLI::Option* triangles_option = nullptr;
  const CLI::Option* coverage_option = nullptr;

  void add_to(CLI::App& app) {
    triangles_option =
        app.add_option("--triangles", triangles,
                       "Fill the triangles of a file instead, one a line, '#' comments: " +
                           triangle_format.description +
                           " in pixels, colours 0 to 255 (default white; three blend)")
            ->type_name("FILE");
    coverage_option =
        app.add_option("--coverage", coverage,
                       "Also write how many triangles covered each pixel, 16 bit a pixel")
            ->type_name("FILE.pgm");
  }

  bool given() const { return triangles_option->count() + coverage_option->count() > 0; }

  void run(Run& run) const {
    if (triangles_option->count() == 0)
      throw UsageError("--coverage: expected --triangles FILE with it");
    if (coverage_option->count() > 0 && coverage.extension() != ".pgm") {
      throw UsageError("--coverage " + coverage.string() +
                       ": expected a file name that ends in .pgm");
    }
    TriangleDrawing drawing(run, run.size({640, 480}), coverage);
    for_each_row(triangles, triangle_format, [&](const NumberRow& row) { drawing.draw(row); });
    drawing.finish(run);
  }
};

}  // namespace

OwnInput own_triangles() {
  auto flags = std::make_shared<Flags>();
  return {.add_flags = [flags](CLI::App& app) { flags->add_to(app); },
          .given = [flags] { return flags->given(); },
          .run = [flags](Run& run) { flags->run(run); }};
}

}  // namespace rasterlab

#include "02_triangles/own_triangles.h"

#include "common/image/files.h"
#include "common/lines/number_rows.h"
#include "common/triangles/barycentric.h"
#include "common/triangles/coverage.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/rasterize.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

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

/// Triangles filled and counted one after the other.
class TriangleDrawing {
 public:
  TriangleDrawing(const Run& run, Size size)
      : rung_(asked_rung(run)),
        image_(size.width, size.height),
        coverage_(size.width, size.height) {
    if (!exact()) scratch_ = Image<Rgb8>(size.width, size.height);
  }

  void draw(const NumberRow& row) {
    const Corners corners = corners_at(row);
    const std::int64_t before = pixels_;
    if (row.numbers.size() == 15) {
      fill(corners, {color_at(row, 6), color_at(row, 9), color_at(row, 12)});
    } else {
      fill(corners, to_rgb8(row.numbers.size() == 9 ? color_at(row, 6) : Color(1, 1, 1)));
    }
    ++triangles_;
    if (pixels_ == before) ++skipped_[reason_for_nothing(corners)];
  }

  void finish(Run& run, const std::filesystem::path& coverage_file) const {
    run.statistics()["triangles"] = triangles_;
    run.statistics()["pixels"] = pixels_;
    run.statistics()["skipped"] = skipped_;
    run.picture("triangles", image_);
    if (coverage_file.empty()) return;
    write_image(coverage_file, coverage_);
    run.announce(coverage_file);
  }

 private:
  bool exact() const { return &rung_ == &fill_ladder.back(); }

  void fill(const Corners& corners, const Rgb8& color) {
    if (!exact()) return fill_by_rung(corners, [&](int, int) { return color; });
    for_each_wide_span(corners, image_.width(), image_.height(), [&](int y, int begin, int end) {
      std::fill(image_.row(y) + begin, image_.row(y) + end, color);
      std::for_each(coverage_.row(y) + begin, coverage_.row(y) + end, &count_up);
      pixels_ += end - begin;
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
    rasterize_wide_triangle(
        corners, image_.width(), image_.height(),
        [&](int x, int y, const Eigen::Vector3d& weights) { set(x, y, blend(weights)); });
  }

  /// Covered as the rung says, coloured as `color_at(x, y)` says.
  template <class ColorAt>
  void fill_by_rung(const Corners& corners, ColorAt color_at) {
    for_each_drawn_pixel(rung_.fill, corners, scratch_,
                         [&](int x, int y) { set(x, y, color_at(x, y)); });
  }

  void set(int x, int y, const Rgb8& color) {
    image_(x, y) = color;
    count_up(coverage_(x, y));
    ++pixels_;
  }

  std::string reason_for_nothing(const Corners& corners) const {
    const PixelBox box = pixel_box(corners, image_.width(), image_.height());
    if (box.right < box.left || box.bottom < box.top) return "outside";
    const SnappedTriangle snapped = snap(corners, max_wide_coordinate);
    return cross<Int128>(snapped[0], snapped[1], snapped[2]) == 0 ? "no_area" : "no_centre_covered";
  }

  const FillRung& rung_;
  Image<Rgb8> image_;
  Coverage coverage_;
  Image<Rgb8> scratch_;  ///< black
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
    TriangleDrawing drawing(run, run.size({640, 480}));
    for_each_row(triangles, triangle_format, [&](const NumberRow& row) { drawing.draw(row); });
    drawing.finish(run, coverage);
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

#include "01_lines/own_lines.h"

#include "common/image/check.h"
#include "common/lines/draw_line_gradient.h"
#include "common/lines/draw_line_list.h"
#include "common/lines/draw_pixels.h"
#include "common/lines/line_ladder.h"
#include "common/lines/line_steps.h"
#include "common/lines/number_rows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

const RowFormat line_format{.description = "x0 y0 x1 y1 [r g b [r g b]]", .counts = {4, 7, 10}};

Point point_at(const NumberRow& row, std::size_t first) {
  Point point;
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = row.numbers[first + i];
    if (value != std::floor(value)) row.fail("expected whole pixels, found a fraction");
    if (std::abs(value) > max_point_coordinate)
      row.fail("expected coordinates within ±1073741824 (2^30)");
    point[static_cast<int>(i)] = static_cast<int>(value);
  }
  return point;
}

/// The rung that --algorithm asked for; the last when it did not.
const LineRung& asked_rung(const Run& run) {
  const std::string& name = run.settings().algorithm;
  if (name.empty()) return line_ladder.back();
  const auto* rung =
      std::find_if(line_ladder.begin(), line_ladder.end(),
                   [&](const LineRung& candidate) { return candidate.name == name; });
  if (rung == line_ladder.end())
    throw UsageError("--algorithm " + name + ": expected one of --algorithm list");
  return *rung;
}

class LineDrawing {
 public:
  LineDrawing(const Run& run, Size size)
      : rung_(asked_rung(run)), image_(size.width, size.height) {}

  void draw(const NumberRow& row) {
    const Point p0 = point_at(row, 0);
    const Point p1 = point_at(row, 2);
    const Color c0 = row.numbers.size() >= 7 ? color_at(row, 4) : Color(1, 1, 1);
    ++lines_;
    if (row.numbers.size() == 10) {
      draw_waiting();
      const StepRange visible = LineSteps(p0, p1).inside(image_.width(), image_.height());
      drawn_.add(std::max<std::int64_t>(visible.last - visible.first + 1, 0));
      draw_line_gradient(image_, p0, c0, p1, color_at(row, 7));
    } else if (&rung_ == &line_ladder.back()) {
      wait({p0, p1}, to_rgb8(c0));
    } else {
      if (LineSteps(p0, p1).last() >= longest_naive) {
        row.fail("expected at most 2^26 pixels, as " + std::string(rung_.name) +
                 " walks the whole line");
      }
      drawn_.add(draw_pixels(image_, rung_.line(p0, p1), to_rgb8(c0)));
    }
  }

  void finish(Run& run) {
    draw_waiting();
    run.statistics()["lines"] = lines_;
    run.statistics()["lines_outside"] = lines_ - drawn_.lines;
    run.statistics()["pixels"] = drawn_.pixels;
    run.picture("lines", image_);
  }

 private:
  static constexpr std::int64_t longest_naive = std::int64_t{1} << 26;
  static constexpr std::size_t longest_list = std::size_t{1} << 20;

  /// Lines of one colour that follow each other are drawn together.
  void wait(const Segment& segment, const Rgb8& color) {
    if (color != color_ || waiting_.size() == longest_list) draw_waiting();
    color_ = color;
    waiting_.push_back(segment);
  }

  void draw_waiting() {
    const DrawnLines drawn = draw_line_list(image_, waiting_, color_);
    drawn_.pixels += drawn.pixels;
    drawn_.lines += drawn.lines;
    waiting_.clear();
  }

  const LineRung& rung_;
  Image<Rgb8> image_;
  std::vector<Segment> waiting_;
  Rgb8 color_;
  std::int64_t lines_ = 0;
  DrawnLines drawn_;
};

}  // namespace

OwnInput own_lines() {
  struct Flag {
    std::filesystem::path file;
    const CLI::Option* option = nullptr;
  };
  auto flag = std::make_shared<Flag>();
  return {
      .add_flags =
          [flag](CLI::App& app) {
            flag->option =
                app.add_option("--lines", flag->file,
                               "Draw the lines of a file instead, one a line, '#' comments: " +
                                   line_format.description +
                                   " in whole pixels, colours 0 to 255 (default white; two blend)")
                    ->type_name("FILE");
          },
      .given = [flag] { return flag->option->count() > 0; },
      .run =
          [flag](Run& run) {
            LineDrawing drawing(run, run.size({640, 480}));
            for_each_row(flag->file, line_format, [&](const NumberRow& row) { drawing.draw(row); });
            drawing.finish(run);
          }};
}

}  // namespace rasterlab
